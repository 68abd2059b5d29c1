//! The coefficient of restitution of two given bodies as a function of their impact velocity.

use crate::elementwise::{apply, each};
use crate::errors::{end, name, value};
use pyo3::prelude::*;

use restitution::{
    Contact, End, Material, MaterialError, Plane, Sphere, ViscoelasticContact, characteristic_velocity_from,
};

/// The coefficient of restitution of two given bodies; `restitution.Restitution` in Python gives it units.
#[pyclass(frozen, subclass, module = "restitution", name = "_Curve")]
#[derive(Clone)]
pub struct Restitution {
    curve: restitution::Restitution,
    /// The characteristic velocity as it was given.
    g_star: Option<f64>,
    /// The contact, where the bodies are known.
    contact: Option<ViscoelasticContact>,
}

/// The factor, the end, `g*` as given, and radius, mass, modulus and dissipative constant of the bodies.
type State = (f64, String, Option<f64>, Option<((f64, f64, f64), f64)>);

impl Restitution {
    /// The curve alone.
    pub fn of(curve: restitution::Restitution, g_star: Option<f64>) -> Self {
        Self { curve, g_star, contact: None }
    }

    fn of_contact(contact: ViscoelasticContact, end: End) -> Self {
        Self { curve: contact.restitution(end), g_star: None, contact: Some(contact) }
    }

    fn course<'py>(
        &self,
        velocity: &Bound<'py, PyAny>,
        what: impl Fn(restitution::Course) -> f64 + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let missing = || value("durations and lengths need bodies: make the curve with from_material");
        let (contact, end) = (self.contact.ok_or_else(missing)?, self.curve.end());
        let at = move |g| contact.course(g, end).ok().flatten().map_or(f64::NAN, &what);
        apply(velocity, each(at))
    }
}

#[pymethods]
impl Restitution {
    #[staticmethod]
    fn from_g_star(g_star: f64, end: &str) -> PyResult<Self> {
        if !(g_star > 0.0 && g_star.is_finite()) {
            return Err(value(MaterialError::NotPositive {
                quantity: "characteristic velocity g*",
                value: g_star,
            }));
        }
        Ok(Self::of(restitution::Restitution::from_g_star(g_star, self::end(end)?), Some(g_star)))
    }

    #[staticmethod]
    fn from_measured(velocity: f64, epsilon: f64, end: &str) -> PyResult<Self> {
        let end = self::end(end)?;
        let g_star = characteristic_velocity_from(velocity, epsilon, end).map_err(value)?;
        Ok(Self::of(restitution::Restitution::from_g_star(g_star, end), Some(g_star)))
    }

    #[staticmethod]
    fn from_u_at_unit_velocity(u: f64, end: &str) -> PyResult<Self> {
        if !(u > 0.0 && u.is_finite()) {
            return Err(value(MaterialError::NotPositive { quantity: "u at unit velocity", value: u }));
        }
        Ok(Self::of(restitution::Restitution::from_u_at_unit_velocity(u, self::end(end)?), None))
    }

    /// SI units throughout; the second body is `None` for a rigid plane, a material for a plane, both for a sphere.
    #[staticmethod]
    fn from_bodies(
        first: (f64, f64, f64),
        radius: f64,
        second: Option<(f64, f64, f64)>,
        second_radius: Option<f64>,
        a: f64,
        end: &str,
    ) -> PyResult<Self> {
        let material = |(young, poisson, density)| Material::new(young, poisson, density).map_err(value);
        let sphere = Sphere::new(material(first)?, radius).map_err(value)?;
        let contact = match (second, second_radius) {
            (None, _) => Contact::with_plane(&sphere, Plane::Rigid),
            (Some(second), None) => Contact::with_plane(&sphere, Plane::Of(material(second)?)),
            (Some(second), Some(radius)) => {
                Contact::of_spheres(&sphere, &Sphere::new(material(second)?, radius).map_err(value)?)
            }
        };
        let contact = ViscoelasticContact::new(contact.map_err(value)?, a).map_err(value)?;
        Ok(Self::of_contact(contact, self::end(end)?))
    }

    /// The same bodies, with the dissipation that one measured pair fixes.
    fn calibrated(&self, velocity: f64, epsilon: f64) -> PyResult<Self> {
        let missing = || value("there are no bodies: make the curve with from_material");
        let (contact, end) = (self.contact.ok_or_else(missing)?, self.curve.end());
        let contact = ViscoelasticContact::from_measurement(*contact.contact(), velocity, epsilon, end);
        Ok(Self::of_contact(contact.map_err(value)?, end))
    }

    /// The coefficient of restitution at impact velocities in m/s: a float or an array of any shape; NaN below 0.
    fn epsilon<'py>(&self, velocity: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        apply(velocity, |g, out| self.curve.epsilon_batch(g, out))
    }

    /// 1 - epsilon at impact velocities in m/s, accurate where it is small.
    fn loss<'py>(&self, velocity: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        apply(velocity, |g, out| self.curve.one_minus_epsilon_batch(g, out))
    }

    /// The damping parameter u = (3/2) A (rho/m_eff)^(2/5) g^(1/5) of impact velocities in m/s.
    fn u<'py>(&self, velocity: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        apply(velocity, |g, out| self.curve.u_batch(g, out))
    }

    /// The impact velocities in m/s that belong to damping parameters u.
    fn velocity<'py>(&self, u: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        apply(u, each(|u| self.curve.velocity(u)))
    }

    /// How long the contact lasts, in s, at impact velocities in m/s; NaN where it is not followed (u > 20).
    fn duration<'py>(&self, velocity: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.course(velocity, |course| course.duration)
    }

    /// The largest compression in m, at impact velocities in m/s; NaN where it is not followed (u > 20).
    fn largest_compression<'py>(&self, velocity: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.course(velocity, |course| course.maximal_compression)
    }

    /// Where the contact ends.
    #[getter]
    fn end(&self) -> &'static str {
        name(self.curve.end())
    }

    /// The characteristic velocity g* in m/s, at which (g/g*)^(1/5) = 1 (eq. 31).
    #[getter]
    fn g_star(&self) -> f64 {
        self.g_star.unwrap_or_else(|| self.curve.g_star())
    }

    /// The dissipative constant A in s; None where the bodies are not known.
    #[getter]
    fn dissipative_constant(&self) -> Option<f64> {
        self.contact.map(|contact| contact.dissipative_constant())
    }

    /// What makes the same curve again: for pickles.
    #[getter]
    fn state(&self) -> State {
        let bodies = self.contact.map(|pair| {
            let contact = pair.contact();
            let numbers = (contact.effective_radius(), contact.effective_mass(), contact.effective_modulus());
            (numbers, pair.dissipative_constant())
        });
        (self.curve.factor(), name(self.curve.end()).to_owned(), self.g_star, bodies)
    }

    /// The curve that a state was taken from, bit by bit.
    #[staticmethod]
    fn restored(state: State) -> PyResult<Self> {
        let (factor, end, g_star, bodies) = state;
        let curve = restitution::Restitution::from_factor(factor, self::end(&end)?);
        let contact = bodies.map(|((radius, mass, modulus), a)| {
            ViscoelasticContact::new(Contact::new(radius, mass, modulus)?, a)
        });
        Ok(Self { curve, g_star, contact: contact.transpose().map_err(value)? })
    }

    /// A copy, which a subclass in Python is made of.
    #[new]
    fn new(curve: &Self) -> Self {
        curve.clone()
    }

    fn __call__<'py>(&self, velocity: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.epsilon(velocity)
    }

    fn __eq__(&self, other: &Self) -> bool {
        self.curve == other.curve && self.contact == other.contact
    }
}
