//! Queries, as text and in fixed point.

use std::path::Path;

use num_bigint::{BigInt, Sign};
use verlock::Vec3;
use verlock::geometry::Triangle;
use verlock::geometry::sweep::{Impact, Motion, Sweep};
use verlock::math::Real;

/// What touches what.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    VertexFace,
    EdgeEdge,
}

impl Kind {
    pub fn of_path(path: &Path) -> Option<Self> {
        let path = path.to_str()?;
        match [path.contains("vertex-face"), path.contains("edge-edge")] {
            [true, false] => Some(Self::VertexFace),
            [false, true] => Some(Self::EdgeEdge),
            _ => None,
        }
    }
}

/// A question, and the answer to it.
pub struct Query {
    kind: Kind,
    motions: [Motion<Vec3>; 4],
    pub touches: bool,
    pub is_rounded: bool,
}

impl Query {
    pub fn impact(&self) -> Option<Impact> {
        // Points are rounded by half a unit at most along each axis, and so what is between two of
        // them by less than two units.
        let gap = if self.is_rounded { Real::from_raw(2) } else { Real::ZERO };
        let sweep = Sweep { gap, ..Sweep::default() };
        let [a, b, c, d] = self.motions;
        match self.kind {
            Kind::VertexFace => sweep.vertex_face(a, [b, c, d]),
            Kind::EdgeEdge => sweep.edge_edge([a, b], [c, d]),
        }
    }
}

type Ratio = (BigInt, BigInt);

/// All queries of a text. An error tells the line, counted from 1.
pub fn parse(text: &str, kind: Kind) -> Result<Vec<Query>, String> {
    let lines = text.lines().enumerate().map(|(k, line)| {
        self::line(line).ok_or_else(|| format!("line {}: not x,X,y,Y,z,Z,r", k + 1))
    });
    let lines = lines.collect::<Result<Vec<_>, _>>()?;
    let chunks = lines.chunks(8).enumerate().map(|(k, lines)| {
        let query = <&[_; 8]>::try_from(lines).ok().and_then(|lines| query(lines, kind));
        query.ok_or_else(|| format!("line {}: not eight lines of one answer", 8 * k + 1))
    });
    chunks.collect()
}

fn line(line: &str) -> Option<([Ratio; 3], bool)> {
    let fields: Vec<_> = line.split(',').map(str::trim).collect();
    let [x, over_x, y, over_y, z, over_z, answer] = fields[..] else { return None };
    let ratio = |n: &str, d: &str| {
        let (n, d): Ratio = (n.parse().ok()?, d.parse().ok()?);
        (d.sign() == Sign::Plus).then_some((n, d))
    };
    let touches = match answer {
        "0" => false,
        "1" => true,
        _ => return None,
    };
    Some(([ratio(x, over_x)?, ratio(y, over_y)?, ratio(z, over_z)?], touches))
}

fn query(lines: &[([Ratio; 3], bool); 8], kind: Kind) -> Option<Query> {
    let touches = lines[0].1;
    if lines.iter().any(|line| line.1 != touches) {
        return None;
    }
    let shift = shift(lines.iter().flat_map(|line| &line.0));
    let mut is_rounded = false;
    let points = lines.each_ref().map(|(point, _)| {
        let raw = point.each_ref().map(|ratio| {
            let (raw, is_exact) = scaled(ratio, shift);
            is_rounded |= !is_exact;
            raw
        });
        Vec3::from_raw(raw)
    });
    let motions = [0, 1, 2, 3].map(|k| Motion::new(points[k], points[k + 4]));
    Some(Query { kind, motions, touches, is_rounded })
}

/// The highest power of two by which none of some numbers leaves the range: how large a scene is
/// does not matter to when something touches.
fn shift<'a>(ratios: impl Iterator<Item = &'a Ratio> + Clone) -> i64 {
    let bits = |(n, d): &Ratio| n.bits().cast_signed() - d.bits().cast_signed() + 1;
    let range = i64::from(Triangle::COORDINATE_MAX.ilog2());
    // A number is below 2 to the power of its bits.
    range - ratios.map(bits).max().unwrap_or(0)
}

/// A number times a power of two, rounded to the nearest whole one, and whether it was one.
fn scaled((n, d): &Ratio, shift: i64) -> (i64, bool) {
    let power = BigInt::from(1) << shift.unsigned_abs();
    let (n, d) = if shift < 0 { (n.clone(), d * power) } else { (n * power, d.clone()) };
    let twice: BigInt = 2 * &n + &d;
    // Whole part, towards minus infinity.
    let mut raw = &twice / (2 * &d);
    if twice.sign() == Sign::Minus && &raw * 2 * &d != twice {
        raw -= 1;
    }
    let is_exact = &raw * &d == n;
    (i64::try_from(raw).expect("in range, by the choice of the power"), is_exact)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A vertex falls by 2 from a height of 1 / `over` to a face; it is at (x, x).
    fn fall(x: &str, over: &str, answer: u8) -> String {
        let face = format!("0,1,0,1,0,1,{answer}\n1,1,0,1,0,1,{answer}\n0,1,0,1,1,1,{answer}\n");
        let below = format!("{x},1,{over},{x},{answer}\n");
        format!("{x},1,{over},{x},{answer}\n{face}{}{face}", below.replace("1,3,", "-5,3,"))
    }

    #[test]
    fn answers_are_right() {
        // Thirds are rounded.
        let text = [fall("1,4", "3", 1), fall("3,4", "3", 0), fall("1,2", "3", 1)].concat();
        let queries = parse(&text, Kind::VertexFace).expect("three queries");
        assert_eq!(queries.len(), 3);
        for query in &queries {
            assert_eq!(query.impact().is_some(), query.touches);
            assert!(query.is_rounded);
        }
        let halves = text.replace("1,3,", "1,2,").replace("-5,3,", "-3,2,");
        let queries = parse(&halves, Kind::VertexFace).expect("three queries");
        let time = queries[0].impact().map(|impact| impact.time.raw());
        assert_eq!((queries[0].is_rounded, time), (false, Some(1 << 28)), "a quarter of the way");
    }

    #[test]
    fn numbers_are_scaled_up_and_down() {
        let ratio = |n: i64, d: i64| (BigInt::from(n), BigInt::from(d));
        let huge = (BigInt::from(3) << 200, BigInt::from(1));
        let least = shift([&huge, &ratio(-1, 7)].into_iter());
        assert_eq!(scaled(&huge, least), (3 << 58, true));
        assert_eq!(scaled(&ratio(-1, 7), least), (0, false));
        assert_eq!(scaled(&ratio(-7, 2), 0), (-3, false));
        assert_eq!(scaled(&ratio(-8, 3), 0), (-3, false));
        assert_eq!(scaled(&ratio(-5, 4), 2), (-5, true));
    }

    #[test]
    fn bad_lines_are_named() {
        let good = fall("1,4", "2", 1);
        let error = |text: &str| parse(text, Kind::EdgeEdge).err();
        assert_eq!(error(&good), None);
        let none = good.replacen("0,1", "0,0", 1);
        assert_eq!(error(&none).as_deref(), Some("line 2: not x,X,y,Y,z,Z,r"));
        let two = good.replacen(",1\n", ",0\n", 1);
        assert_eq!(error(&two).as_deref(), Some("line 1: not eight lines of one answer"));
        let short = good.lines().take(7).collect::<Vec<_>>().join("\n");
        assert_eq!(error(&short).as_deref(), Some("line 1: not eight lines of one answer"));
    }
}
