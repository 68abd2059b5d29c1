//! The inputs of discrete-element codes, there and back.

mod constant;
mod input;
mod lines;
mod pairs;
mod rebound;
mod request;

pub(super) use input::CodeInput;
pub(in crate::commands) use request::{Dissipation, Request};

use super::end_of;
use crate::CliError;
use crate::args::EndOfContact;
use restitution::codes::ConstantCode;
use restitution::{End, MaterialError};

/// A discrete-element code.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(in crate::commands) enum Code {
    /// LAMMPS, pair_style granular, hertz with damping viscoelastic.
    Lammps,
    /// LAMMPS, pair_style gran/hertz/history.
    LammpsHertzHistory,
    /// LAMMPS, pair_style granular with damping coeff_restitution: the same coefficient at every velocity.
    LammpsConstant,
    /// LIGGGHTS, pair_style gran model hertz/stiffness.
    Liggghts,
    /// LIGGGHTS, model hertz: the same coefficient at every velocity.
    LiggghtsConstant,
    /// YADE, Ip2_FrictMat_FrictMat_MindlinPhys with en and vn.
    Yade,
    /// YADE, Ip2_FrictMat_FrictMat_MindlinPhys with betan: the same coefficient at every velocity, any version.
    YadeConstant,
    /// MercuryDPM, HertzianBSHPViscoelastic.
    Mercury,
    /// ESyS-Particle, HertzianViscoElasticPrms.
    Esys,
    /// Project Chrono, smooth contacts with SetKn and SetGn.
    Chrono,
    /// Project Chrono, smooth contacts with material properties: the same coefficient at every velocity.
    ChronoConstant,
    /// Chrono's DEM-Engine: the same coefficient at every velocity.
    DemEngine,
    /// Lethe, hertz_mindlin_limit_overlap: the same coefficient at every velocity.
    Lethe,
    /// MFiX, DES_COLL_MODEL = 'HERTZIAN': the same coefficient at every velocity.
    Mfix,
    /// Kratos, DEM_D_Hertz_viscous_Coulomb: the same coefficient at every velocity.
    Kratos,
    /// TrixiParticles, HertzContactModel: the same coefficient at every velocity.
    TrixiParticles,
    /// REBOUND, a callback for coefficient_of_restitution.
    Rebound,
}

impl Code {
    /// The code as one of constant coefficients, if it is.
    fn constant(self) -> Option<ConstantCode> {
        Some(match self {
            Self::LammpsConstant => ConstantCode::Lammps,
            Self::LiggghtsConstant => ConstantCode::Liggghts,
            Self::YadeConstant => ConstantCode::Yade,
            Self::ChronoConstant => ConstantCode::Chrono,
            Self::DemEngine => ConstantCode::DemEngine,
            Self::Lethe => ConstantCode::Lethe,
            Self::Mfix => ConstantCode::Mfix,
            Self::Kratos => ConstantCode::Kratos,
            Self::TrixiParticles => ConstantCode::TrixiParticles,
            _ => return None,
        })
    }

    /// Whether its damping multiplies the effective mass.
    fn multiplies_mass(self) -> bool {
        matches!(self, Self::Lammps | Self::LammpsHertzHistory | Self::Liggghts | Self::Chrono)
    }

    /// Whether it has the unit systems of LAMMPS.
    fn has_units(self) -> bool {
        matches!(self, Self::Lammps | Self::LammpsHertzHistory | Self::Liggghts)
    }

    /// What the lines rest on, if the code was not run on them (docs/codes.md).
    fn read_not_run(self) -> Option<&'static str> {
        match self {
            Self::Mercury => Some("HertzianBSHPViscoelasticSpecies"),
            Self::Chrono | Self::ChronoConstant => Some("ChSystemSMC, ChContactForceModel Hertz"),
            Self::DemEngine => Some("FrictionlessHertzianForceModel.cu"),
            Self::Lethe => Some("particle_particle_contact_force.h"),
            Self::Mfix => Some("check_solids_dem.f and calc_force_dem.f of 21.3"),
            Self::TrixiParticles => Some("contact_models.jl of 0.5.4"),
            _ => None,
        }
    }

    /// What begins a remark.
    fn remark(self) -> &'static str {
        match self {
            Self::Mercury | Self::Chrono | Self::ChronoConstant | Self::DemEngine | Self::Kratos => "//",
            _ => "#",
        }
    }

    /// The end of contact: the one asked for, if the code has it, or the code's default.
    pub(in crate::commands) fn end(self, asked: Option<EndOfContact>) -> Result<End, CliError> {
        let only = |code, only: End| match asked.map(end_of) {
            Some(end) if end != only => Err(CliError::usage(MaterialError::EndNotOffered { code, end })),
            _ => Ok(only),
        };
        if let Some(code) = self.constant()
            && let [end] = code.ends()
        {
            return only(code.name(), *end);
        }
        match self {
            Self::LammpsHertzHistory => only("gran/hertz/history", End::ZeroCompression),
            Self::Yade => only("YADE", End::ZeroForce),
            Self::Mercury => only("MercuryDPM", End::ZeroForce),
            Self::Esys => only("ESyS-Particle", End::ZeroForce),
            Self::Chrono => only("Chrono", End::ZeroForce),
            _ => Ok(end_of(asked.unwrap_or_default())),
        }
    }

    /// The keys of its input, as the code calls them.
    fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Lammps => &["k_n", "eta_n0", "E", "nu", "limit_damping", "coeff_restitution", "tsuji"],
            Self::LammpsConstant => &["coeff_restitution", "tsuji"],
            Self::LiggghtsConstant => &["coefficientRestitution"],
            Self::LammpsHertzHistory => &["Kn", "gamma_n"],
            Self::Liggghts => &["kn", "gamman", "limitForce", "coefficientRestitution"],
            Self::Yade => &["en", "vn", "young", "poisson", "betan"],
            Self::YadeConstant => &["betan"],
            Self::Mercury => &["effectiveElasticModulus", "dissipation"],
            Self::Esys => &["A", "E", "nu"],
            Self::Chrono => &["kn", "gn"],
            Self::ChronoConstant => &["restitution"],
            Self::DemEngine => &["CoR"],
            Self::Lethe => &["restitution"],
            Self::Mfix => &["DES_EN_INPUT"],
            Self::Kratos => &["COEFFICIENT_OF_RESTITUTION"],
            Self::TrixiParticles => &["damping_coefficient"],
            Self::Rebound => &[],
        }
    }
}
