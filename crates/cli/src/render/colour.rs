//! Colours, and what has which.

use verlock::world::Shade;

/// Red, green and blue.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Rgb(pub(super) [u8; 3]);

/// A whole share of a colour.
pub(super) const WHOLE: u32 = 256;

pub(super) const BACKGROUND: Rgb = Rgb([0xF9, 0xFA, 0xFB]);
pub(super) const GAP: Rgb = Rgb([0xD5, 0xDA, 0xE1]);
pub(super) const GRID: Rgb = Rgb([0xB9, 0xC3, 0xCF]);
pub(super) const SHADOW: Rgb = Rgb([0xDD, 0xE1, 0xE7]);
pub(super) const TEXT: Rgb = Rgb([0x4B, 0x57, 0x66]);
const DARK: Rgb = Rgb([0x16, 0x20, 0x2E]);
const LIGHT: Rgb = Rgb([0xFF, 0xFF, 0xFF]);

const PARTICLE: Rgb = Rgb([0x2F, 0x6D, 0xC4]);
const PINNED: Rgb = Rgb([0xD8, 0x31, 0x45]);
const DISABLED: Rgb = Rgb([0xA9, 0xB1, 0xBC]);
const RELAXED: Rgb = Rgb([0x55, 0x63, 0x75]);
const STRETCHED: Rgb = Rgb([0xE5, 0x48, 0x1D]);
const SQUEEZED: Rgb = Rgb([0x17, 0x8F, 0xC9]);
const FACE_FRONT: Rgb = Rgb([0xE0, 0x7B, 0x55]);
const FACE_BACK: Rgb = Rgb([0x4C, 0x8F, 0x9E]);
const COLLIDER: Rgb = Rgb([0x8F, 0xA8, 0xC8]);
const CONTACT: Rgb = Rgb([0xB8, 0x00, 0x4F]);

/// The strain, 16 fractional bits, at which a line has the colour of the stretched: 5 %.
const STRAIN_SHOWN: i32 = (1 << 16) / 20;

impl Rgb {
    /// The way from this colour to another, `share` of [`WHOLE`] along.
    pub(super) fn mix(self, other: Self, share: u32) -> Self {
        let share = share.min(WHOLE);
        let mut mixed = self.0;
        for (channel, to) in mixed.iter_mut().zip(other.0) {
            let sum = u32::from(*channel) * (WHOLE - share) + u32::from(to) * share;
            // A mean of two bytes.
            *channel = ((sum + WHOLE / 2) / WHOLE).to_le_bytes()[0];
        }
        Self(mixed)
    }

    /// Lit by a share of [`WHOLE`] of all light.
    pub(super) fn lit(self, light: u32) -> Self {
        let half = WHOLE / 2;
        if light < half {
            DARK.mix(self, half + light)
        } else {
            self.mix(LIGHT, (light - half) / 2)
        }
    }
}

/// The colour of a line or a point.
pub(super) fn of(shade: Shade) -> Rgb {
    match shade {
        Shade::Particle => PARTICLE,
        Shade::Pinned => PINNED,
        Shade::Distance { strain } => {
            let extreme = if strain.raw() < 0 { SQUEEZED } else { STRETCHED };
            let share = strain.raw().unsigned_abs().min(STRAIN_SHOWN.unsigned_abs());
            RELAXED.mix(extreme, share * WHOLE / STRAIN_SHOWN.unsigned_abs())
        }
        Shade::Face => FACE_FRONT,
        Shade::HalfSpace => GRID,
        Shade::Collider => COLLIDER,
        Shade::Contact => CONTACT,
        _ => DISABLED,
    }
}

/// The colour of a side of a face.
pub(super) fn of_face(shade: Shade, front: bool) -> Rgb {
    if shade == Shade::Face && !front { FACE_BACK } else { of(shade) }
}
