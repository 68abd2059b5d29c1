//! JavaScript.

use super::{Language, Rows};

pub(super) static LANGUAGE: Language = Language {
    name: "javascript",
    aliases: &["js", "mjs", "node"],
    title: "JavaScript, of a page or of Node.js, a script",
    file: "NAME.js",
    comment: "// ",
    rows: Rows { before: "  [", between: ", ", after: "],\n", suffix: "" },
    reserved: &["module", "require", "console", "process"],
    template: TEMPLATE,
};

const TEMPLATE: &str = r#"{HEAD}
// Functions of a number:
//     {NAME}_epsilon(u)               the coefficient of restitution
//     {NAME}_loss(u)                  1 - epsilon, with all its digits where u is small
//     {NAME}_slope(u)                 d epsilon/d u
//     {NAME}_u_of_velocity(velocity, gStar)    u of the size of a velocity; both in the same unit
//     {NAME}_epsilon_of_velocity(velocity, gStar)
?VELOCITY //     {NAME}_u_at_m_per_s(velocity)   the same for the g* above
?VELOCITY //     {NAME}_epsilon_at_m_per_s(velocity)
//
// Self-check: node {FILE}
//
// Written by: restitution export --lang {LANGUAGE} {OPTIONS} --name {NAME}

// The polynomial of each piece, in the distance to its end as a part of its width, constant first.
const {NAME}_table = [
{TABLE}
];
?NEAR const {NAME}_near = [{NEAR}];
const {NAME}_view = new DataView(new ArrayBuffer(8));

/** The upper half of the bits of x. */
function {NAME}_upper(x) {
  {NAME}_view.setFloat64(0, x);
  return {NAME}_view.getUint32(0);
}

/** The row of u, the distance to the end of its piece, the exponent of its width, and how many periods of the law at
 * infinity lie between; null outside the range. */
function {NAME}_locate(u) {
?LAW   if (!(u >= {LOW})) return null;
!LAW   if (!(u >= {LOW} && u <= {HIGH})) return null;
  let periods = 0;
  let first = {FIRST};
?LAW   let upper;
?LAW   if (u >= {LAW_FROM}) {
?LAW     periods = Math.floor((({NAME}_upper(u) >>> 20) - ({NAME}_upper({LAW_FROM}) >>> 20)) / {OCTAVES});
?LAW     upper = {NAME}_upper(u) - periods * {OCTAVES} * 1048576;
?LAW     first = {LAW_FIRST} - {LAW_ROW};
?LAW   } else {
?LAW     upper = {NAME}_upper(u + {SHIFT});
?LAW   }
!LAW   const upper = {NAME}_upper(u + {SHIFT});
  const row = Math.min(Math.max((upper >>> ({REST} - 32)) - first, 0), {LAST_ROW});
  const exponent = (upper >>> 20) - {BITS} - 1023;
  {NAME}_view.setUint32(0, (upper & 0xfffff) | 0x3ff00000);
  const part = ({NAME}_view.getFloat64(0) - 1) * 2 ** {BITS};
  return { row, c: {NAME}_table[row], distance: 1 - (part - Math.floor(part)), exponent, periods };
}

/** What epsilon has above its value at the end of the piece. */
function {NAME}_rise(c, distance) {
  let rise = 0;
  for (let k = {DEGREE}; k >= 1; k--) rise = (rise + c[k]) * distance;
  return rise;
}

/** x times a power of two. */
function {NAME}_scaled(x, exponent) {
  const power = (n) => {
    {NAME}_view.setUint32(0, (n + 1023) << 20);
    {NAME}_view.setUint32(4, 0);
    return {NAME}_view.getFloat64(0);
  };
  for (; exponent < -1000 && x !== 0; exponent += 1000) x *= power(-1000);
  return x === 0 ? x : x * power(exponent);
}

/** Coefficient of restitution at u; NaN outside the range. */
function {NAME}_epsilon(u) {
  const at = {NAME}_locate(u);
  if (at === null) return NaN;
?LAW   return {NAME}_scaled(at.c[0] + {NAME}_rise(at.c, at.distance), -5 * at.periods);
!LAW   return at.c[0] + {NAME}_rise(at.c, at.distance);
}

/** 1 - epsilon at u; NaN outside the range. */
function {NAME}_loss(u) {
  const at = {NAME}_locate(u);
  if (at === null) return NaN;
?NEAR   if (at.row < {NEAR_ROW}) {
?NEAR !ROOT     const x = u;
?NEAR ?ROOT     const x = Math.sqrt(u);
?NEAR     let near = 0;
?NEAR     for (let k = {NEAR_LAST}; k >= 0; k--) near = near * x + {NAME}_near[k];
?NEAR     return u * near;
?NEAR   }
?LAW   if (at.periods > 0) return 1 - {NAME}_epsilon(u);
  return 1 - at.c[0] - {NAME}_rise(at.c, at.distance);
}

/** d epsilon/d u at u; NaN outside the range. */
function {NAME}_slope(u) {
  const at = {NAME}_locate(u);
  if (at === null) return NaN;
  let sum = 0;
  for (let k = {DEGREE}; k >= 1; k--) sum = sum * at.distance + k * at.c[k];
  return -{NAME}_scaled(sum, -at.exponent - {FALL} * at.periods);
}

/** u of the size of a velocity; gStar is the characteristic velocity, in the same unit. */
function {NAME}_u_of_velocity(velocity, gStar) {
  return {U_AT_G_STAR} * Math.pow(Math.abs(velocity) / gStar, 0.2);
}

/** Coefficient of restitution of the size of a velocity. */
function {NAME}_epsilon_of_velocity(velocity, gStar) {
  return {NAME}_epsilon({NAME}_u_of_velocity(velocity, gStar));
}
?VELOCITY 
?VELOCITY /** u of the size of a velocity in m/s, for g* = {G_STAR} m/s. */
?VELOCITY function {NAME}_u_at_m_per_s(velocity) {
?VELOCITY   return {NAME}_u_of_velocity(velocity, {G_STAR});
?VELOCITY }
?VELOCITY 
?VELOCITY /** Coefficient of restitution of the size of a velocity in m/s. */
?VELOCITY function {NAME}_epsilon_at_m_per_s(velocity) {
?VELOCITY   return {NAME}_epsilon_of_velocity(velocity, {G_STAR});
?VELOCITY }

/** The largest relative errors of epsilon and of 1 - epsilon at certified values, and whether they are kept. */
function {NAME}_self_check() {
  const check = [ // u, certified epsilon and 1 - epsilon
{POINTS}
  ];
  const worst = Math.max(...check.map(([u, epsilon]) => Math.abs({NAME}_epsilon(u) / epsilon - 1)));
  const worstLoss = Math.max(...check.map(([u, , loss]) => Math.abs({NAME}_loss(u) - loss) / (loss || 1)));
  return { worst, worstLoss, kept: worst <= {TOLERANCE} && worstLoss <= {LOSS_BOUND} };
}

if (typeof module === "object" && typeof require === "function") {
  module.exports = {
    epsilon: {NAME}_epsilon,
    loss: {NAME}_loss,
    slope: {NAME}_slope,
    u_of_velocity: {NAME}_u_of_velocity,
    epsilon_of_velocity: {NAME}_epsilon_of_velocity,
?VELOCITY     u_at_m_per_s: {NAME}_u_at_m_per_s,
?VELOCITY     epsilon_at_m_per_s: {NAME}_epsilon_at_m_per_s,
    self_check: {NAME}_self_check,
  };
  if (require.main === module) {
    const { worst, worstLoss, kept } = {NAME}_self_check();
    console.log(`largest relative errors ${worst.toExponential(2)} of {TOLERANCE}, ${worstLoss.toExponential(2)} of {LOSS_BOUND}`);
    process.exit(kept ? 0 : 1);
  }
}
"#;
