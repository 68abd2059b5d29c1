//! What a column can hold, by which names it is found and in which units it comes.

use restitution_units::Dimension;

/// How the coefficient was measured, which decides what columns are needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Impact velocity and coefficient, perhaps with its standard deviation and the duration of the contact.
    Coefficients,
    /// Speeds before and after.
    Speeds,
    /// Heights of the drop and of the rebound.
    Heights,
    /// Times of successive impacts of a bouncing ball.
    Bounces,
}

impl Method {
    pub(super) const ALL: [Self; 4] = [Self::Coefficients, Self::Speeds, Self::Heights, Self::Bounces];

    /// The columns that it needs.
    pub(super) fn needs(self) -> &'static [Role] {
        match self {
            Self::Coefficients => &[Role::Velocity, Role::Epsilon],
            Self::Speeds => &[Role::Before, Role::After],
            Self::Heights => &[Role::Drop, Role::Rebound],
            Self::Bounces => &[Role::Time],
        }
    }

    /// The columns that it can use.
    pub(super) fn takes(self) -> &'static [Role] {
        match self {
            Self::Coefficients => &[Role::Velocity, Role::Epsilon, Role::Sigma, Role::Duration],
            Self::Speeds => &[Role::Before, Role::After, Role::Sigma, Role::Duration],
            Self::Heights => &[Role::Drop, Role::Rebound, Role::Sigma, Role::Duration],
            Self::Bounces => &[Role::Time],
        }
    }
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    Velocity,
    Epsilon,
    Sigma,
    Duration,
    Before,
    After,
    Drop,
    Rebound,
    Time,
}

impl Role {
    pub(super) const ALL: [Self; 9] = [
        Self::Velocity,
        Self::Epsilon,
        Self::Sigma,
        Self::Duration,
        Self::Before,
        Self::After,
        Self::Drop,
        Self::Rebound,
        Self::Time,
    ];

    /// What it is called in `--columns` and in messages.
    pub(super) fn key(self) -> &'static str {
        match self {
            Self::Velocity => "velocity",
            Self::Epsilon => "epsilon",
            Self::Sigma => "sigma",
            Self::Duration => "duration",
            Self::Before => "before",
            Self::After => "after",
            Self::Drop => "drop",
            Self::Rebound => "rebound",
            Self::Time => "time",
        }
    }

    /// What one value of it is called in a message.
    pub(super) fn noun(self) -> &'static str {
        match self {
            Self::Velocity => "velocity",
            Self::Epsilon => "coefficient",
            Self::Sigma => "standard deviation",
            Self::Duration => "duration",
            Self::Before => "speed before",
            Self::After => "speed after",
            Self::Drop => "height of the drop",
            Self::Rebound => "height of the rebound",
            Self::Time => "time",
        }
    }

    /// The kind of its unit; `None` for plain numbers and percentages.
    pub(super) fn dimension(self) -> Option<Dimension> {
        match self {
            Self::Velocity | Self::Before | Self::After => Some(Dimension::Velocity),
            Self::Epsilon | Self::Sigma => None,
            Self::Duration | Self::Time => Some(Dimension::Time),
            Self::Drop | Self::Rebound => Some(Dimension::Length),
        }
    }

    /// The names by which a column is found, in small letters, words separated by blanks.
    pub(super) fn names(self) -> &'static [&'static str] {
        match self {
            Self::Velocity => &[
                "g",
                "v",
                "velocity",
                "speed",
                "impact velocity",
                "impact speed",
                "collision velocity",
                "incident velocity",
                "incidence velocity",
                "normal velocity",
                "normal impact velocity",
                "relative velocity",
                "v imp",
                "v impact",
                "vimp",
                "vi",
                "v i",
                "v n",
                "vn",
                "v in",
                "vin",
                "v0",
                "v 0",
                "vn impact",
                "v n impact",
                "normal speed",
                "geschwindigkeit",
                "aufprallgeschwindigkeit",
                "vitesse",
                "vitesse d'impact",
                "velocidad",
                "velocidad de impacto",
            ],
            Self::Epsilon => &[
                "epsilon",
                "eps",
                "e",
                "cor",
                "restitution",
                "coefficient of restitution",
                "restitution coefficient",
                "normal coefficient of restitution",
                "coefficient of normal restitution",
                "coefficient",
                "en",
                "e n",
                "ε",
                "stoßzahl",
                "stosszahl",
                "restitutionskoeffizient",
                "coefficient de restitution",
                "coeficiente de restitución",
                "coeficiente de restitucion",
            ],
            Self::Sigma => &[
                "sigma",
                "σ",
                "sigma epsilon",
                "sigma eps",
                "sigma e",
                "sigma cor",
                "epsilon error",
                "eps error",
                "e error",
                "cor error",
                "epsilon err",
                "eps err",
                "e err",
                "cor err",
                "error of epsilon",
                "epsilon sd",
                "e sd",
                "cor sd",
                "sd epsilon",
                "sd e",
                "epsilon std",
                "e std",
                "cor std",
                "std epsilon",
                "std e",
                "std cor",
                "u(e)",
                "delta epsilon",
                "delta e",
                "d epsilon",
            ],
            Self::Duration => {
                &["duration", "contact time", "contact duration", "t c", "tc", "collision time"]
            }
            Self::Before => &[
                "before",
                "v before",
                "velocity before",
                "speed before",
                "impact velocity",
                "impact speed",
                "v in",
                "vin",
                "vi",
                "v i",
                "v imp",
                "v impact",
                "v1",
                "v 1",
                "incoming",
                "incident velocity",
            ],
            Self::After => &[
                "after",
                "v after",
                "velocity after",
                "speed after",
                "rebound velocity",
                "rebound speed",
                "v out",
                "vout",
                "vr",
                "v r",
                "vf",
                "v f",
                "v reb",
                "v rebound",
                "v2",
                "v 2",
                "outgoing",
                "exit velocity",
            ],
            Self::Drop => &[
                "drop",
                "drop height",
                "height of drop",
                "release height",
                "height",
                "h",
                "h0",
                "h 0",
                "h drop",
                "h1",
                "h 1",
                "hd",
                "fallhöhe",
            ],
            Self::Rebound => &[
                "rebound",
                "rebound height",
                "height of rebound",
                "bounce height",
                "bounce",
                "h rebound",
                "h reb",
                "h bounce",
                "hr",
                "h r",
                "h1",
                "h 1",
                "h2",
                "h 2",
                "h'",
                "sprunghöhe",
                "rücksprunghöhe",
                "rückprallhöhe",
            ],
            Self::Time => &["t", "time", "times", "bounce time", "impact time", "time of impact"],
        }
    }
}
