//! From a velocity to the damping `u`, to any precision.

use crate::CliError;
use crate::exact::{Exact, at_least_zero};
use crate::units::{self, Quantity};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use restitution_law::ForceLaw;
use restitution_real::Ball;
use std::fmt;

/// Arguments that say how strongly the bodies dissipate.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Damping, for velocities")]
#[group(id = "damping", multiple = true)]
pub(in crate::commands) struct DampingArgs {
    /// Characteristic velocity g*, with epsilon = 1 - s + ..., s = (g/g*)^p
    #[arg(long, value_name = "G", value_parser = units::velocity)]
    g_star: Option<Quantity>,
    /// Dissipative constant A of two equal spheres, such as 1e-6s
    #[arg(long, value_name = "A", value_parser = units::time, conflicts_with = "g_star")]
    dissipative_constant: Option<Quantity>,
    /// Young's modulus, such as 9.4GPa
    #[arg(long, value_name = "Y", value_parser = units::modulus, requires = "dissipative_constant")]
    young: Option<Quantity>,
    /// Poisson's ratio
    #[arg(long, value_name = "NU", value_parser = at_least_zero, requires = "dissipative_constant")]
    poisson: Option<Exact>,
    /// Mass density, such as 917kg/m3
    #[arg(long, value_name = "DENSITY", value_parser = units::density, requires = "dissipative_constant")]
    density: Option<Quantity>,
    /// Radius of both spheres, such as 2.75cm
    #[arg(long, value_name = "R", value_parser = units::length, requires = "dissipative_constant")]
    radius: Option<Quantity>,
}

/// A damping known to any precision.
#[derive(Clone, Debug)]
pub(in crate::commands) enum Source {
    /// A rational number.
    Exact(BigRational),
    /// `(s^p)/|C_1|` with the scaled velocity `g/g*`.
    Scaled { ratio: BigRational, law: ForceLaw },
    /// `pi^(-2/5) base^(1/5)` with a rational base, for two equal spheres.
    Material { base: BigRational },
}

impl Source {
    /// Encloses the damping at `prec` bits.
    pub(in crate::commands) fn at(&self, prec: u32) -> Ball {
        let wide = prec + 32;
        match self {
            Self::Exact(u) => Ball::from_rational(u, prec),
            Self::Scaled { ratio, .. } if ratio.is_zero() => Ball::zero().with_prec(prec),
            Self::Scaled { ratio, law } => {
                Ball::from_rational(ratio, wide).pow(&law.velocity_exponent()) / first_loss(law, wide)
            }
            Self::Material { base } if base.is_zero() => Ball::zero().with_prec(prec),
            Self::Material { base } => {
                (Ball::from_rational(base, wide) / Ball::pi(wide).powi(2)).fifth_root()
            }
        }
    }
}

/// `-C_1 = 2 ((a+1)/2)^r B(r, 3/2)/(a+1)`, `r = (gamma+1)/(a+1)`: what defines `g*`.
fn first_loss(law: &ForceLaw, prec: u32) -> Ball {
    let step = law.elastic_step();
    let two = BigRational::from_integer(2.into());
    let exponent = law.damping_step() / &step;
    let beta = Ball::beta(&exponent, &BigRational::new(3.into(), 2.into()), prec);
    Ball::from_rational(&(&step / &two), prec).pow(&exponent)
        * beta
        * Ball::from_rational(&(two / step), prec)
}

impl fmt::Display for DampingArgs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(g_star) = &self.g_star {
            return write!(f, "given as {g_star}");
        }
        let parts = [
            self.dissipative_constant.as_ref().map(|a| format!("A = {a}")),
            self.young.as_ref().map(|young| format!("Y = {young}")),
            self.poisson.as_ref().map(|poisson| format!("nu = {poisson}")),
            self.density.as_ref().map(|density| format!("density {density}")),
            self.radius.as_ref().map(|radius| format!("radius {radius}")),
        ];
        write!(f, "two equal spheres, {}", parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
    }
}

impl DampingArgs {
    /// Whether any of them is there.
    pub(in crate::commands) fn given(&self) -> bool {
        self.g_star.is_some() || self.dissipative_constant.is_some()
    }

    /// The damping at one impact velocity.
    pub(in crate::commands) fn source(
        &self,
        velocity: &Quantity,
        law: &ForceLaw,
    ) -> Result<Source, CliError> {
        let g = velocity.si();
        if g.is_negative() {
            return Err(CliError::usage(format!(
                "the impact velocity {velocity} is negative: give its size"
            )));
        }
        if let Some(g_star) = &self.g_star {
            let g_star = positive(Some(g_star.si()), "--g-star")?;
            let p = law.velocity_exponent();
            if p.is_negative() && g.is_zero() {
                return Err(CliError::usage(
                    "at velocity 0 the damping of this law is infinite: give a positive velocity",
                ));
            }
            return Ok(Source::Scaled { ratio: g / g_star, law: law.clone() });
        }
        if *law != ForceLaw::viscoelastic_spheres() {
            return Err(CliError::usage(
                "a material is that of viscoelastic spheres: give --g-star with another --law",
            ));
        }
        Ok(Source::Material { base: self.base(g)? })
    }

    /// `u^5 pi^2` of two equal spheres: `u = (3/2) A k^(2/5) g^(1/5)`, `k = rho/m_eff`.
    ///
    /// ```text
    /// rho = 2 Y sqrt(R/2)/(3 (1 - nu^2)),   m_eff = (2/3) pi R^3 density
    /// u^5 = (3/2)^5 A^5 g Y^2/(2 pi^2 R^5 (1 - nu^2)^2 density^2)
    /// ```
    fn base(&self, g: &BigRational) -> Result<BigRational, CliError> {
        let si = |q: &Option<Quantity>| q.as_ref().map(|q| q.si().clone());
        let a = positive(si(&self.dissipative_constant).as_ref(), "--dissipative-constant")?;
        let young = positive(si(&self.young).as_ref(), "--young")?;
        let density = positive(si(&self.density).as_ref(), "--density")?;
        let radius = positive(si(&self.radius).as_ref(), "--radius")?;
        let poisson = self.poisson.as_ref().map(|p| p.value().clone());
        let strain = poisson.map(|nu| BigRational::one() - &nu * &nu);
        let strain = positive(strain.as_ref(), "--poisson, below 1,")?;
        let stiffness = young / (strain * density);
        let front = num_traits::pow(BigRational::new(3.into(), 2.into()) * a / radius, 5);
        Ok(front * g * &stiffness * &stiffness / BigRational::from_integer(2.into()))
    }
}

fn positive(value: Option<&BigRational>, name: &str) -> Result<BigRational, CliError> {
    let value = value.filter(|v| v.is_positive()).cloned();
    value.ok_or_else(|| {
        CliError::usage(format!("the damping is not known: give {name} with a positive value"))
    })
}
