//! First contacts in big integers: roots of polynomials, and signs at those roots.
//!
//! Features are seen as the hull of the differences of their corners, which they touch where it
//! holds 0: of 3 for a vertex and a face, of 4 for two edges. All are linear polynomials of time.
//! A contact begins where these lie in one plane with 0, which is a cubic's root; or if they always
//! do, where two are in line with 0; or if these always are, where one is 0. Whether it is a
//! contact is then told by signs of polynomials, at an algebraic number.

use num_bigint::BigInt;
use num_bigint::Sign::{self, Minus, NoSign, Plus};

/// Coefficients, that of 1 first, without zeros at the end.
type Poly = Vec<BigInt>;
type Vector = [Poly; 3];

/// An algebraic number in [0, 1].
#[derive(Clone, Debug)]
pub struct Time {
    /// In units of 2^-bits.
    low: BigInt,
    bits: u64,
    /// It is the one root of this between `low` and `low + 1`; without, it is `low`.
    root: Option<Poly>,
}

fn trimmed(mut p: Poly) -> Poly {
    while p.last().is_some_and(|c| c.sign() == NoSign) {
        p.pop();
    }
    p
}

fn minus(p: &Poly, q: &Poly) -> Poly {
    let at = |p: &Poly, k: usize| p.get(k).cloned().unwrap_or_default();
    trimmed((0..p.len().max(q.len())).map(|k| at(p, k) - at(q, k)).collect())
}

fn negative(p: &Poly) -> Poly {
    p.iter().map(|c| -c).collect()
}

fn plus(p: &Poly, q: &Poly) -> Poly {
    minus(p, &negative(q))
}

fn times(p: &Poly, q: &Poly) -> Poly {
    let mut product = vec![BigInt::ZERO; (p.len() + q.len()).saturating_sub(1)];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    trimmed(product)
}

fn derivative(p: &Poly) -> Poly {
    p.iter().enumerate().skip(1).map(|(k, c)| c * BigInt::from(k)).collect()
}

fn gcd_of(a: BigInt, b: BigInt) -> BigInt {
    if b.sign() == NoSign { a } else { gcd_of(b.clone(), a % b) }
}

/// Divided by what all coefficients have in common.
fn primitive(p: Poly) -> Poly {
    let common = p.iter().fold(BigInt::ZERO, |common, c| gcd_of(common, c.clone()));
    if common.sign() == NoSign {
        return p;
    }
    let common = BigInt::from(common.magnitude().clone());
    p.into_iter().map(|c| c / &common).collect()
}

/// Quotient and rest of `p / q`, both up to positive factors.
fn divided(p: &Poly, q: &Poly) -> (Poly, Poly) {
    let lead = q.last().expect("not 0");
    let square = lead * lead;
    let (mut quotient, mut rest) = (vec![], p.clone());
    while rest.len() >= q.len() {
        let shift = rest.len() - q.len();
        let factor = rest.last().expect("not 0") * lead;
        let mut term = vec![BigInt::ZERO; shift];
        term.push(factor);
        let scaled = |p: &Poly| p.iter().map(|c| c * &square).collect::<Poly>();
        quotient = plus(&scaled(&quotient), &term);
        rest = minus(&scaled(&rest), &times(q, &term));
    }
    (primitive(quotient), primitive(rest))
}

fn gcd(p: &Poly, q: &Poly) -> Poly {
    if q.is_empty() { p.clone() } else { gcd(q, &divided(p, q).1) }
}

/// The sign at `place / 2^bits`.
fn sign_at(p: &Poly, place: &BigInt, bits: u64) -> Sign {
    let mut value = BigInt::ZERO;
    for (k, c) in p.iter().rev().enumerate() {
        value = value * place + (c << (bits * k as u64));
    }
    value.sign()
}

/// Sturm's chain: how often its signs change tells the roots.
fn chain(p: &Poly) -> Vec<Poly> {
    let mut chain = vec![p.clone(), derivative(p)];
    while let [.., p, q] = &chain[..]
        && !q.is_empty()
    {
        let rest = negative(&divided(p, q).1);
        chain.push(rest);
    }
    chain
}

/// How many roots there are above `low` and not above `high`, both in units of 2^-bits.
fn roots_between(chain: &[Poly], low: &BigInt, high: &BigInt, bits: u64) -> usize {
    let changes = |place| {
        let signs = chain.iter().map(|p| sign_at(p, place, bits)).filter(|&sign| sign != NoSign);
        let signs: Vec<_> = signs.collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    };
    changes(low) - changes(high)
}

/// All roots above 0 and not above 1, of a polynomial that is not 0.
fn roots(p: &Poly) -> Vec<Time> {
    if p.len() < 2 {
        return vec![];
    }
    // Without multiple roots.
    let p = divided(p, &gcd(p, &derivative(p))).0;
    let chain = chain(&p);
    let mut found = vec![];
    let mut open = vec![(BigInt::ZERO, 0)];
    while let Some((low, bits)) = open.pop() {
        let high = &low + 1;
        let mut count = roots_between(&chain, &low, &high, bits);
        if count > 0 && sign_at(&p, &high, bits) == NoSign {
            found.push(Time { low: high, bits, root: None });
            count -= 1;
        }
        // A root at the lower end would spoil the signs that halving goes by.
        if count == 1 && sign_at(&p, &low, bits) != NoSign {
            found.push(Time { low, bits, root: Some(p.clone()) });
        } else if count > 0 {
            let low = low << 1;
            // The upper end of the upper half has been found already.
            let mid = &low + 1;
            let at_high = sign_at(&p, &(&low + 2), bits + 1) == NoSign;
            let upper = roots_between(&chain, &mid, &(&low + 2), bits + 1);
            if upper > usize::from(at_high) {
                open.push((mid, bits + 1));
            }
            open.push((low, bits + 1));
        }
    }
    found
}

impl Time {
    fn zero() -> Self {
        Self { low: BigInt::ZERO, bits: 0, root: None }
    }

    /// Halves the interval.
    fn refine(&mut self) {
        let Some(root) = &self.root else { return };
        let middle: BigInt = (&self.low << 1) + 1;
        self.bits += 1;
        let sign = sign_at(root, &middle, self.bits);
        let below = sign_at(root, &(&self.low << 1), self.bits);
        if sign == NoSign {
            (self.low, self.root) = (middle, None);
        } else if sign == below {
            self.low = middle;
        } else {
            self.low = &self.low << 1;
        }
    }

    /// The sign of a polynomial there.
    fn sign(&mut self, p: &Poly) -> Sign {
        let Some(root) = self.root.clone() else { return sign_at(p, &self.low, self.bits) };
        if p.is_empty() || divided(p, &root).1.is_empty() {
            return NoSign;
        }
        let mut common = None;
        for round in 0.. {
            if self.root.is_none() {
                return sign_at(p, &self.low, self.bits);
            }
            if let Some(sign) = constant_sign(p, &self.low, self.bits) {
                return sign;
            }
            if round == 12 {
                let g = gcd(p, &root);
                common = (g.len() > 1).then(|| chain(&g));
            }
            if let Some(chain) = &common {
                // Inside it is the only root of `root`; another may be the upper end.
                let high = &self.low + 1;
                let ends = usize::from(sign_at(&chain[0], &high, self.bits) == NoSign);
                if roots_between(chain, &self.low, &high, self.bits) > ends {
                    return NoSign;
                }
            }
            self.refine();
        }
        unreachable!("a sign is found, or a common root")
    }

    /// Whether it is not before `raw` units of 2^-30.
    pub fn is_at_least(&mut self, raw: i32) -> bool {
        // t - raw / 2^30
        let p = trimmed(vec![BigInt::from(-raw), BigInt::from(1 << 30)]);
        self.sign(&p) != Minus
    }

    /// Rounded down, in units of 2^-30.
    pub fn floor(&mut self) -> i32 {
        while self.root.is_some() && self.bits < 40 {
            self.refine();
        }
        let shifted: BigInt = (&self.low << 30) >> self.bits;
        i32::try_from(shifted).expect("at most 1")
    }
}

/// The sign of a polynomial between `low` and `low + 1` (in units of 2^-bits), if it is seen to be
/// the same everywhere there.
fn constant_sign(p: &Poly, low: &BigInt, bits: u64) -> Option<Sign> {
    // In x, where t = (low + x) / 2^bits: its coefficients by Horner's scheme.
    let degree = p.len() as u64 - 1;
    let mut local: Poly = vec![];
    for (k, c) in p.iter().rev().enumerate() {
        let mut next = times(&local, &vec![low.clone(), BigInt::from(1)]);
        next.resize(next.len().max(1), BigInt::ZERO);
        next[0] += c << (bits * k as u64);
        local = next;
    }
    debug_assert!(local.len() as u64 <= degree + 1);
    let (first, rest) = local.split_first()?;
    let spread: BigInt = rest.iter().map(|c| BigInt::from(c.magnitude().clone())).sum();
    (BigInt::from(first.magnitude().clone()) > spread).then(|| first.sign())
}

fn cross(p: &Vector, q: &Vector) -> Vector {
    let minor = |j: usize, k: usize| minus(&times(&p[j], &q[k]), &times(&p[k], &q[j]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn dot(p: &Vector, q: &Vector) -> Poly {
    let [x, y, z] = [0, 1, 2].map(|k| times(&p[k], &q[k]));
    plus(&plus(&x, &y), &z)
}

/// Whether 0 is in the hull of points of one plane at a time.
fn is_contact(points: &[Vector], time: &mut Time) -> bool {
    let count = points.len();
    let mut is_zero = |v: &Vector| v.iter().all(|c| time.sign(c) == NoSign);
    if points.iter().any(&mut is_zero) {
        return true;
    }
    let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| [i, j]));
    for [i, j] in pairs {
        let (p, q) = (&points[i], &points[j]);
        if cross(p, q).iter().all(|c| time.sign(c) == NoSign) && time.sign(&dot(p, q)) != Plus {
            return true;
        }
    }
    let triples = (0..count)
        .flat_map(|i| (i + 1..count).flat_map(move |j| (j + 1..count).map(move |k| [i, j, k])));
    for triple in triples {
        let [p, q, r] = triple.map(|k| &points[k]);
        let turns = [cross(p, q), cross(q, r), cross(r, p)];
        let normal = [0, 1, 2].map(|k| plus(&plus(&turns[0][k], &turns[1][k]), &turns[2][k]));
        let is_flat = normal.iter().all(|c| time.sign(c) == NoSign);
        if !is_flat
            && time.sign(&dot(p, &turns[1])) == NoSign
            && turns.iter().all(|turn| time.sign(&dot(turn, &normal)) != Minus)
        {
            return true;
        }
    }
    false
}

/// Every time at which features may begin to touch and do; the first is the first contact.
///
/// `corners` are those of both, at the start and at the end: a vertex and 3 corners of a face, or
/// the ends of two edges.
pub fn contacts(corners: &[[[i64; 3]; 2]; 4], is_face: bool) -> Vec<Time> {
    let between = |i: usize, j: usize| {
        [0, 1, 2].map(|k| {
            let at = |time: usize| BigInt::from(corners[i][time][k]) - corners[j][time][k];
            trimmed(vec![at(0), at(1) - at(0)])
        })
    };
    let pairs: &[[usize; 2]] =
        if is_face { &[[0, 1], [0, 2], [0, 3]] } else { &[[0, 2], [0, 3], [1, 2], [1, 3]] };
    let points: Vec<_> = pairs.iter().map(|&[i, j]| between(i, j)).collect();
    let mut times = vec![Time::zero()];
    let volume = dot(&cross(&points[0], &points[1]), &points[2]);
    if volume.is_empty() {
        for (i, p) in points.iter().enumerate() {
            let lines = points[i + 1..].iter().map(|q| cross(p, q));
            let all = lines.chain([p.clone()]).flatten().filter(|p| !p.is_empty());
            times.extend(all.flat_map(|p| roots(&p)));
        }
    } else {
        times.extend(roots(&volume));
    }
    times.retain_mut(|time| is_contact(&points, time));
    times
}
