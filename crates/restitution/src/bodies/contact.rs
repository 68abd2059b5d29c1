//! Hertz's contact of two spheres, or of a sphere and a plane.

use crate::bodies::error::{in_range, positive};
use crate::bodies::material::sphere_mass;
use crate::{Material, MaterialError, Sphere, fifth_root};

/// The body that a sphere meets when it is not a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Plane {
    /// A half-space that does not deform.
    Rigid,
    /// A half-space of a material, of infinite mass.
    Of(Material),
}

/// An elastic contact: effective radius, mass and modulus.
///
/// ```text
/// 1/R_eff = 1/R_1 + 1/R_2,   1/m_eff = 1/m_1 + 1/m_2,   1/E = (1-nu_1^2)/Y_1 + (1-nu_2^2)/Y_2
/// F = rho xi^(3/2),   rho = (4/3) E sqrt(R_eff)
/// ```
///
/// (\[H1882\]; eq. 2 of \[RPBS1999\] for two bodies of one material, `rho = 2 Y sqrt(R_eff)/(3 (1-nu^2))`.)
/// Not certified: f64, a few ulp.
///
/// # Examples
///
/// ```
/// use restitution::{Contact, Material, MaterialError, Plane, Sphere};
///
/// let steel = Material::new(210e9, 0.3, 7800.0)?;
/// let ball = Sphere::new(steel, 0.01)?;
/// let pair = Contact::of_spheres(&ball, &ball)?;
/// assert_eq!(pair.effective_radius(), 0.005);
/// assert!((pair.force_prefactor() / (2.0 * 210e9 * 0.005_f64.sqrt() / (3.0 * 0.91)) - 1.0).abs() < 1e-15);
///
/// let floor = Contact::with_plane(&ball, Plane::Rigid)?;
/// assert_eq!(floor.effective_mass(), ball.mass());
///
/// assert!(matches!(Contact::new(0.0, 1.0, 1e9), Err(MaterialError::NotPositive { .. })));
/// # Ok::<(), MaterialError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    radius: f64,
    mass: f64,
    modulus: f64,
}

impl Contact {
    /// Returns the contact with the given effective radius (m), mass (kg) and modulus (Pa).
    ///
    /// # Errors
    ///
    /// [`MaterialError::NotPositive`] or [`MaterialError::OutOfRange`].
    pub fn new(radius: f64, mass: f64, modulus: f64) -> Result<Self, MaterialError> {
        let contact = Self {
            radius: positive("effective radius", radius)?,
            mass: positive("effective mass", mass)?,
            modulus: positive("effective modulus", modulus)?,
        };
        in_range("force prefactor over the effective mass", contact.force_prefactor() / mass)?;
        Ok(contact)
    }

    /// Returns the contact whose force prefactor is `rho` (N/m^(3/2)) at the given radius and mass.
    ///
    /// # Errors
    ///
    /// As [`Contact::new`].
    pub fn with_prefactor(radius: f64, mass: f64, rho: f64) -> Result<Self, MaterialError> {
        let rho = positive("force prefactor", rho)?;
        Self::new(radius, mass, 0.75 * rho / positive("effective radius", radius)?.sqrt())
    }

    /// Returns the contact of the given effective radius (m) and mass (kg) of two bodies of one material, of Young's modulus `young` (Pa).
    ///
    /// # Errors
    ///
    /// As [`Contact::new`], and [`MaterialError::PoissonRatio`] outside (-1, 1/2].
    pub fn of_one_material(radius: f64, mass: f64, young: f64, poisson: f64) -> Result<Self, MaterialError> {
        if !(poisson > -1.0 && poisson <= 0.5) {
            return Err(MaterialError::PoissonRatio { value: poisson });
        }
        Self::new(radius, mass, 0.5 * young / ((1.0 - poisson) * (1.0 + poisson)))
    }

    /// Returns the contact of two equal spheres of the given radius (m) and density (kg/m^3), with a known effective modulus (Pa).
    ///
    /// # Errors
    ///
    /// As [`Contact::new`].
    ///
    /// # Examples
    ///
    /// ```
    /// use restitution::{Contact, Material, Sphere};
    ///
    /// let glass = Material::new(63e9, 0.23, 2500.0)?;
    /// let alike = Contact::of_equal_spheres(1e-3, 2500.0, glass.effective_modulus())?;
    /// let bead = Sphere::new(glass, 1e-3)?;
    /// assert_eq!(alike, Contact::of_spheres(&bead, &bead)?);
    ///
    /// assert!(Contact::of_equal_spheres(1e-3, -1.0, 1e9).is_err());
    /// # Ok::<(), restitution::MaterialError>(())
    /// ```
    pub fn of_equal_spheres(radius: f64, density: f64, modulus: f64) -> Result<Self, MaterialError> {
        Self::new(0.5 * radius, 0.5 * sphere_mass(radius, density), modulus)
    }

    /// Returns the contact of two spheres.
    ///
    /// # Errors
    ///
    /// [`MaterialError::OutOfRange`] for sizes whose mass or stiffness f64 cannot hold.
    pub fn of_spheres(one: &Sphere, other: &Sphere) -> Result<Self, MaterialError> {
        let radius = effective(one.radius(), other.radius());
        let mass = in_range("effective mass", effective(one.mass(), other.mass()))?;
        let compliance = one.material().compliance() + other.material().compliance();
        Self::new(radius, mass, in_range("effective modulus", 1.0 / compliance)?)
    }

    /// Returns the contact of a sphere and a plane of infinite mass.
    ///
    /// # Errors
    ///
    /// As [`Contact::of_spheres`].
    pub fn with_plane(sphere: &Sphere, plane: Plane) -> Result<Self, MaterialError> {
        let compliance = match plane {
            Plane::Rigid => 0.0,
            Plane::Of(material) => material.compliance(),
        };
        let modulus = 1.0 / (sphere.material().compliance() + compliance);
        Self::new(sphere.radius(), in_range("mass", sphere.mass())?, in_range("effective modulus", modulus)?)
    }

    /// The effective radius `R_eff`, in m.
    pub fn effective_radius(&self) -> f64 {
        self.radius
    }

    /// The effective mass `m_eff`, in kg.
    pub fn effective_mass(&self) -> f64 {
        self.mass
    }

    /// The effective modulus `E`, in Pa; `Y/(2 (1-nu^2))` for two bodies of one material.
    pub fn effective_modulus(&self) -> f64 {
        self.modulus
    }

    /// The prefactor `rho` of Hertz's force `rho xi^(3/2)`, in N/m^(3/2).
    pub fn force_prefactor(&self) -> f64 {
        4.0 / 3.0 * self.modulus * self.radius.sqrt()
    }

    /// The rate `(rho/m_eff)^(2/5)`, in (s/m)^(1/5)/s, of which all times of a collision are made.
    pub(crate) fn rate(&self) -> f64 {
        (self.force_prefactor() / self.mass).powf(0.4)
    }

    /// The unit of time `tau = (m_eff/rho)^(2/5) g^(-1/5)` of a collision at impact velocity `g`, in s.
    ///
    /// # Errors
    ///
    /// [`MaterialError::NotPositive`] for a velocity that is not positive and finite.
    pub fn time_unit(&self, velocity: f64) -> Result<f64, MaterialError> {
        in_range("time unit", 1.0 / (self.rate() * fifth_root(positive("velocity", velocity)?)))
    }
}

/// Returns `a b/(a + b)`, the effective value of two radii or two masses, without overflow on the way.
///
/// # Examples
///
/// ```
/// use restitution::effective;
///
/// assert_eq!(effective(2.0, 2.0), 1.0);
/// assert_eq!(effective(1e-3, f64::INFINITY), 1e-3); // a plane
/// assert!(effective(f64::NAN, 1.0).is_nan());
/// ```
pub fn effective(a: f64, b: f64) -> f64 {
    let (small, large) = if a < b { (a, b) } else { (b, a) };
    small / (1.0 + small / large)
}
