//! Which sections a snapshot has, and which fields their records.

use core::fmt;

use crate::math::{Factor, Real, Unit};

/// The sections of a snapshot, in the order of the file.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
#[repr(u32)]
#[non_exhaustive]
pub enum Section {
    /// Tick, configuration, random generator: one record.
    World = 1,
    /// Generations of the particle slots.
    ParticleSlot = 2,
    /// Positions, one a slot.
    Position = 3,
    /// Displacements of the last substep, one a slot.
    Displacement = 4,
    /// Properties of the particles, one a slot.
    Particle = 5,
    /// Generations of the distance slots.
    DistanceSlot = 6,
    /// Distance constraints, one a slot.
    Distance = 7,
    /// Generations of the half-space slots.
    HalfSpaceSlot = 8,
    /// Half-spaces, one a slot.
    HalfSpace = 9,
    /// What rounding left over of the corrections of start-of-step distances, one each or none.
    Carry = 10,
    /// Generations of the volume slots.
    VolumeSlot = 11,
    /// Volume constraints, one a slot.
    Volume = 12,
    /// Generations of the face slots.
    FaceSlot = 13,
    /// Faces, one a slot.
    Face = 14,
}

/// One number of a record.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Field {
    /// As the API spells it.
    pub name: &'static str,
    /// Width and meaning.
    pub kind: FieldKind,
}

/// Width and meaning of a field.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum FieldKind {
    /// One byte, 0 or 1.
    Bool,
    /// Four bytes, a count or index.
    U32,
    /// Eight bytes.
    U64,
    /// Eight bytes, 24 of the bits a fraction.
    Real,
    /// Four bytes, 24 of the bits a fraction.
    Displacement,
    /// Two bytes, 15 of the bits a fraction of the raw unit of a position.
    Carry,
    /// Four bytes, 30 of the bits a fraction.
    Unit,
    /// Four bytes, 16 of the bits a fraction.
    Factor,
    /// Four bytes, the index of one of these names.
    Variant(&'static [&'static str]),
}

/// The value of a field: its bits, and how to read them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Value {
    /// The bits, zero-extended.
    pub raw: u64,
    /// How to read them.
    pub kind: FieldKind,
}

const fn field(name: &'static str, kind: FieldKind) -> Field {
    Field { name, kind }
}

macro_rules! fields {
    ($($name:literal: $kind:expr),* $(,)?) => {{
        use FieldKind::*;
        const { &[$(field($name, $kind)),*] }
    }};
}

impl Section {
    /// All sections in the order of the file.
    pub const ALL: [Self; 14] = [
        Self::World,
        Self::ParticleSlot,
        Self::Position,
        Self::Displacement,
        Self::Particle,
        Self::DistanceSlot,
        Self::Distance,
        Self::HalfSpaceSlot,
        Self::HalfSpace,
        Self::Carry,
        Self::VolumeSlot,
        Self::Volume,
        Self::FaceSlot,
        Self::Face,
    ];

    /// The section's name in messages.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::World => "world",
            Self::ParticleSlot => "particle-slot",
            Self::Position => "position",
            Self::Displacement => "displacement",
            Self::Particle => "particle",
            Self::DistanceSlot => "distance-slot",
            Self::Distance => "distance",
            Self::Carry => "carry",
            Self::VolumeSlot => "volume-slot",
            Self::Volume => "volume",
            Self::FaceSlot => "face-slot",
            Self::Face => "face",
            Self::HalfSpaceSlot => "half-space-slot",
            Self::HalfSpace => "half-space",
        }
    }

    /// The fields of a record in the order of the file, without gaps.
    #[must_use]
    pub const fn fields(self) -> &'static [Field] {
        match self {
            Self::World => fields! {
                "tick": U64, "phase": U64,
                "tick_rate": U32, "substeps": U32, "iterations": U32,
                "gravity.x": Real, "gravity.y": Real, "gravity.z": Real,
                "damping": Real, "displacement_max": Real,
                "wind.x": Real, "wind.y": Real, "wind.z": Real,
                "random.state": U64, "random.increment": U64,
            },
            Self::ParticleSlot
            | Self::DistanceSlot
            | Self::HalfSpaceSlot
            | Self::VolumeSlot
            | Self::FaceSlot => fields! {
                "generation": U32,
            },
            Self::Position => fields! { "x": Real, "y": Real, "z": Real },
            Self::Displacement => fields! {
                "x": Displacement, "y": Displacement, "z": Displacement,
            },
            Self::Particle => fields! {
                "mass": Real, "gravity_scale": Factor,
                "acceleration.x": Real, "acceleration.y": Real, "acceleration.z": Real,
                "pinned": Bool, "enabled": Bool, "user": U64,
            },
            Self::Distance => fields! {
                "a.index": U32, "a.generation": U32, "b.index": U32, "b.generation": U32,
                "rest_length": Real, "slack": Real, "stiffness": Unit, "compliance": Unit,
                "form": Variant(&["exact", "start-of-step", "root-free", "division-free"]),
                "tear_strain": Factor, "toughness": Factor, "damage": Factor,
                "enabled": Bool, "user": U64,
            },
            Self::Volume => fields! {
                "corners.0.index": U32, "corners.0.generation": U32,
                "corners.1.index": U32, "corners.1.generation": U32,
                "corners.2.index": U32, "corners.2.generation": U32,
                "corners.3.index": U32, "corners.3.generation": U32,
                "rest_volume": Real, "stiffness": Unit, "enabled": Bool, "user": U64,
            },
            Self::Face => fields! {
                "corners.0.index": U32, "corners.0.generation": U32,
                "corners.1.index": U32, "corners.1.generation": U32,
                "corners.2.index": U32, "corners.2.generation": U32,
                "drag": Factor, "enabled": Bool, "user": U64,
            },
            Self::Carry => fields! {
                "a.x": Carry, "a.y": Carry, "a.z": Carry, "b.x": Carry, "b.y": Carry, "b.z": Carry,
            },
            Self::HalfSpace => fields! {
                "point.x": Real, "point.y": Real, "point.z": Real,
                "normal.x": Unit, "normal.y": Unit, "normal.z": Unit,
                "friction": Factor, "restitution": Unit, "enabled": Bool, "user": U64,
            },
        }
    }

    /// Bytes of a record.
    #[must_use]
    pub const fn record_size(self) -> u32 {
        let fields = self.fields();
        let (mut size, mut index) = (0, 0);
        while index < fields.len() {
            size += fields[index].kind.width();
            index += 1;
        }
        size
    }
}

impl FieldKind {
    /// Bytes of the field.
    #[must_use]
    pub const fn width(self) -> u32 {
        match self {
            Self::Bool => 1,
            Self::Carry => 2,
            Self::U32 | Self::Displacement | Self::Unit | Self::Factor | Self::Variant(_) => 4,
            Self::U64 | Self::Real => 8,
        }
    }
}

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Narrow fields hold 32 bits, so the casts only give the sign back.
        let wide = self.raw.cast_signed();
        #[allow(clippy::cast_possible_truncation, reason = "narrow fields hold 32 bits")]
        let narrow = self.raw as i32;
        match self.kind {
            FieldKind::Bool => write!(f, "{}", self.raw != 0),
            FieldKind::U32 | FieldKind::U64 => write!(f, "{}", self.raw),
            FieldKind::Real => Real::from_raw(wide).fmt(f),
            FieldKind::Displacement => Real::from_raw(i64::from(narrow)).fmt(f),
            FieldKind::Unit => Unit::from_raw(narrow).fmt(f),
            FieldKind::Factor => Factor::from_raw(narrow).fmt(f),
            FieldKind::Carry => write!(f, "{}/32768 ulp", narrow << 16 >> 16),
            FieldKind::Variant(names) => {
                let name = usize::try_from(self.raw).ok().and_then(|index| names.get(index));
                f.write_str(name.unwrap_or(&"?"))
            }
        }
    }
}
