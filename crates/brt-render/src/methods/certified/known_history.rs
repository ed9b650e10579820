//! What is proven of a block's ray history, level by level along its mirror rays.

use super::candidates::{List, Lists};
use crate::tracing::{Guide, Lighting, Sight};

/// Levels beyond these are left to rays.
pub(super) const MOST_LEVELS: usize = 8;

/// What all rays of a block meet at one level.
#[derive(Clone, Copy, Debug)]
pub(super) enum KnownSight {
    Unknown,
    Among(List),
    Met(u32),
}

/// How all points of a block at one level see a light.
#[derive(Clone, Copy, Debug)]
pub(super) enum KnownLighting {
    Unknown,
    Among(List),
    Seen,
    Hidden,
}

impl KnownLighting {
    /// Is it the same for all points?
    pub(super) fn is_settled(self) -> bool {
        matches!(self, Self::Seen | Self::Hidden)
    }
}

/// How the points of a block at one level see all lights: a place in [`Lightings`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LevelLights(usize);

/// How the points of all blocks that are open see the lights, each block's behind its parent's.
#[derive(Debug)]
pub(super) struct Lightings {
    /// Number of lights.
    lights: usize,
    known: Vec<KnownLighting>,
}

impl Lightings {
    /// Of a scene with so many lights.
    pub(super) fn new(lights: usize) -> Self {
        Self { lights, known: Vec::new() }
    }

    /// For [`Self::release`].
    pub(super) fn mark(&self) -> usize {
        self.known.len()
    }

    /// Forgets all that was kept since the mark.
    pub(super) fn release(&mut self, mark: usize) {
        self.known.truncate(mark);
    }

    /// A copy that may be written to; nothing is known where there is none yet.
    pub(super) fn inherit(&mut self, from: Option<LevelLights>) -> LevelLights {
        let first = self.known.len();
        match from {
            Some(LevelLights(from)) => {
                self.known.extend_from_within(from..from + self.lights);
            }
            None => self.known.resize(first + self.lights, KnownLighting::Unknown),
        }
        LevelLights(first)
    }

    /// How a light is seen.
    pub(super) fn of(&self, level: LevelLights, light: usize) -> KnownLighting {
        self.known[level.0 + light]
    }

    pub(super) fn set(&mut self, level: LevelLights, light: usize, known: KnownLighting) {
        self.known[level.0 + light] = known;
    }
}

/// One level of a history.
#[derive(Clone, Copy, Debug)]
pub(super) struct Level {
    pub(super) sight: KnownSight,
    /// `None` where no light was looked at.
    pub(super) lights: Option<LevelLights>,
}

impl Level {
    const UNKNOWN: Self = Self { sight: KnownSight::Unknown, lights: None };
}

/// What is known of a block. Its parts inherit it.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownHistory {
    pub(super) levels: [Level; MOST_LEVELS],
    /// Are all samples clear of the edges of what is seen first, but for the doubtful ones?
    pub(super) is_clear: bool,
}

impl KnownHistory {
    /// All rays meet this primitive first.
    pub(super) fn starting_with(primitive: u32, is_clear: bool) -> Self {
        let mut levels = [Level::UNKNOWN; MOST_LEVELS];
        levels[0].sight = KnownSight::Met(primitive);
        Self { levels, is_clear }
    }

    /// The primitive that is seen first.
    pub(super) fn first(&self) -> u32 {
        match self.levels[0].sight {
            KnownSight::Met(primitive) => primitive,
            _ => crate::products::NOTHING,
        }
    }

    /// For tracing a sample of the block.
    pub(super) fn guide<'a>(&'a self, lists: &'a Lists, lightings: &'a Lightings) -> KnownGuide<'a> {
        KnownGuide { levels: &self.levels, lists, lightings }
    }
}

/// A known history as a guide.
#[derive(Clone, Copy)]
pub(super) struct KnownGuide<'a> {
    /// From the current hit on; never empty.
    levels: &'a [Level],
    lists: &'a Lists,
    lightings: &'a Lightings,
}

impl Guide for KnownGuide<'_> {
    #[inline]
    fn lighting(&self, light: usize) -> Lighting<'_> {
        let lights = self.levels.first().and_then(|level| level.lights);
        match lights.map(|lights| self.lightings.of(lights, light)) {
            None | Some(KnownLighting::Unknown) => Lighting::Unknown,
            Some(KnownLighting::Among(list)) => Lighting::Among(self.lists.get(list)),
            Some(KnownLighting::Seen) => Lighting::Seen,
            Some(KnownLighting::Hidden) => Lighting::Hidden,
        }
    }

    #[inline]
    fn mirrored(&self) -> Sight<'_> {
        match self.levels.get(1).map(|level| level.sight) {
            None | Some(KnownSight::Unknown) => Sight::Unknown,
            Some(KnownSight::Among(list)) => Sight::Among(self.lists.get(list)),
            Some(KnownSight::Met(primitive)) => Sight::Met(primitive),
        }
    }

    #[inline]
    fn next(self) -> Self {
        Self { levels: self.levels.get(1..).unwrap_or_default(), ..self }
    }
}
