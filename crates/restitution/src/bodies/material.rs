//! An isotropic solid and a sphere made of it.

use crate::MaterialError;
use crate::bodies::error::{in_range, positive};

/// An isotropic elastic solid: Young's modulus, Poisson's ratio and mass density.
///
/// # Examples
///
/// ```
/// use restitution::{Material, MaterialError};
///
/// let ice = Material::new(9.4e9, 0.33, 917.0)?;
/// assert_eq!(ice.sound_speed(), (9.4e9_f64 / 917.0).sqrt());
///
/// let cork = Material::new(30e6, 0.6, 240.0);
/// assert_eq!(cork, Err(MaterialError::PoissonRatio { value: 0.6 }));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    young: f64,
    poisson: f64,
    density: f64,
}

impl Material {
    /// Returns the solid with Young's modulus `young` (Pa), Poisson's ratio `poisson` and `density` (kg/m^3).
    ///
    /// # Errors
    ///
    /// [`MaterialError::NotPositive`] for a modulus or density that is not positive and finite,
    /// [`MaterialError::PoissonRatio`] outside (-1, 1/2], where 1/2 is an incompressible solid, [`MaterialError::OutOfRange`] if f64 cannot hold the
    /// compliance `(1 - nu^2)/Y` or the speed of sound.
    pub fn new(young: f64, poisson: f64, density: f64) -> Result<Self, MaterialError> {
        let young = positive("Young modulus", young)?;
        if !(poisson > -1.0 && poisson <= 0.5) {
            return Err(MaterialError::PoissonRatio { value: poisson });
        }
        let material = Self { young, poisson, density: positive("density", density)? };
        in_range("compliance of the material", material.compliance())?;
        in_range("ratio of Young modulus and density", young / density)?;
        Ok(material)
    }

    /// Young's modulus `Y`, in Pa.
    pub fn young(&self) -> f64 {
        self.young
    }

    /// Poisson's ratio `nu`.
    pub fn poisson(&self) -> f64 {
        self.poisson
    }

    /// The mass density, in kg/m^3.
    pub fn density(&self) -> f64 {
        self.density
    }

    /// The compliance `(1 - nu^2)/Y` of a half-space, in 1/Pa; Hertz's contact adds those of both bodies.
    pub fn compliance(&self) -> f64 {
        (1.0 - self.poisson) * (1.0 + self.poisson) / self.young
    }

    /// The effective modulus `E = Y/(2 (1 - nu^2))` of two bodies of this material, in Pa.
    pub fn effective_modulus(&self) -> f64 {
        0.5 / self.compliance()
    }

    /// The speed of sound in a thin bar, `c = sqrt(Y/density)`, in m/s.
    ///
    /// Waves in bulk are faster, those of shear slower, for any Poisson's ratio by a factor of order one;
    /// condition (iii) of section II of \[RPBS1999\] asks for `g << c` only.
    pub fn sound_speed(&self) -> f64 {
        (self.young / self.density).sqrt()
    }
}

/// A sphere of one material.
///
/// # Examples
///
/// ```
/// use restitution::{Material, MaterialError, Sphere};
///
/// let glass = Material::new(63e9, 0.23, 2500.0)?;
/// let bead = Sphere::new(glass, 1e-3)?;
/// assert!((bead.mass() - 1.0472e-5).abs() < 1e-9);
///
/// assert!(matches!(Sphere::new(glass, -1e-3), Err(MaterialError::NotPositive { .. })));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    material: Material,
    radius: f64,
}

impl Sphere {
    /// Returns the sphere of the given `radius`, in m.
    ///
    /// # Errors
    ///
    /// [`MaterialError::NotPositive`] for a radius that is not positive and finite, [`MaterialError::OutOfRange`]
    /// if f64 cannot hold the mass.
    pub fn new(material: Material, radius: f64) -> Result<Self, MaterialError> {
        let sphere = Self { material, radius: positive("radius", radius)? };
        in_range("mass of the sphere", sphere.mass())?;
        Ok(sphere)
    }

    /// What it is made of.
    pub fn material(&self) -> &Material {
        &self.material
    }

    /// The radius, in m.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The mass `(4/3) pi R^3 density`, in kg.
    pub fn mass(&self) -> f64 {
        sphere_mass(self.radius, self.material.density)
    }

    /// The time that a Rayleigh wave takes around the sphere, in s: what codes take their critical time step from.
    ///
    /// ```text
    /// t_R = pi R sqrt(density/G)/(0.1631 nu + 0.8766),   G = Y/(2 (1 + nu))
    /// ```
    ///
    /// The denominator is a fit to the speed of the wave; few digits of it count.
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::{Material, Sphere};
    ///
    /// let glass = Material::new(63e9, 0.23, 2500.0)?;
    /// assert!((Sphere::new(glass, 1e-3)?.rayleigh_time() - 1.0738e-6).abs() < 1e-10);
    ///
    /// assert!(Sphere::new(glass, 0.0).is_err());
    /// # Ok::<(), restitution::MaterialError>(())
    /// ```
    pub fn rayleigh_time(&self) -> f64 {
        let Material { young, poisson, density } = self.material;
        let shear = young / (2.0 * (1.0 + poisson));
        core::f64::consts::PI * self.radius * (density / shear).sqrt() / (0.1631 * poisson + 0.8766)
    }
}

/// Returns the mass `(4/3) pi R^3 density` of a sphere, in kg.
///
/// # Examples
///
/// ```
/// use restitution::sphere_mass;
///
/// assert!((sphere_mass(0.01, 7800.0) - 0.032672).abs() < 1e-6);
/// assert!(sphere_mass(f64::NAN, 7800.0).is_nan());
/// ```
pub fn sphere_mass(radius: f64, density: f64) -> f64 {
    4.0 / 3.0 * core::f64::consts::PI * radius.powi(3) * density
}
