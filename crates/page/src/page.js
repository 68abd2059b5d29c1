// The state of the page, from its fields to its figures. The evaluators above are exported by the project itself; what
// else is known of the theory is in `theory`.

const ENDS = [
  { name: "zero compression", style: "one", epsilon: zero_compression_epsilon, loss: zero_compression_loss },
  { name: "zero force", style: "two", epsilon: zero_force_epsilon, loss: zero_force_loss },
];
const EXAMPLES = {
  ice: [9.4, 0.33, 917],
  steel: [206, 0.28, 7850],
  glass: [63, 0.24, 2500],
  "aluminium oxide": [370, 0.22, 3950],
  "cellulose acetate": [3.2, 0.28, 1319],
};
const DECADES = 5; // shown of the velocity
const DRAWN = 3000; // measurements at most

const at = (id) => document.getElementById(id);
function text(value, digits = 6) {
  if (!Number.isFinite(value)) return "–";
  const rounded = Number(value.toPrecision(digits));
  return rounded !== 0 && Math.abs(rounded) < 1e-4 ? rounded.toExponential() : rounded.toString();
}

// Reads a number as people write it: a decimal point, or a comma that cannot mean thousands.
function read(id, what) {
  const field = at(id);
  const value = parse(field.value);
  const good = Number.isFinite(value);
  field.setAttribute("aria-invalid", String(!good));
  if (!good) throw new Error(`${what} is '${field.value}': write a number such as 0.5 or 1e-3`);
  return value;
}

function parse(written) {
  let word = written.trim();
  if (/^[-+]?\d*,\d+(e[-+]?\d+)?$/i.test(word) && !/^[-+]?[1-9]\d{0,2},\d{3}$/.test(word)) word = word.replace(",", ".");
  return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(word) ? Number(word) : NaN;
}

function positive(id, what) {
  const value = read(id, what);
  if (!(value > 0)) {
    at(id).setAttribute("aria-invalid", "true");
    throw new Error(`${what} is ${value}: give a positive number`);
  }
  return value;
}

// u at 1 m/s, and the bodies where they are known; SI units.
function pair() {
  const by = document.querySelector("input[name=by]:checked").value;
  const unit = Number(at("unit").value);
  const bodies = by.startsWith("material") ? contact() : null;
  let rate;
  if (by === "g-star") {
    rate = Math.pow(positive("g-star", "g*") * unit, -0.2) / theory.slope;
  } else if (by === "material") {
    rate = 1.5 * positive("dissipative", "A") * 1e-6 * bodies.rate;
  } else {
    const velocity = positive("measured-velocity", "the impact velocity") * unit;
    const epsilon = positive("measured-epsilon", "the measured ε");
    if (!(epsilon < 1)) throw new Error(`a measured ε of ${epsilon} has no damping that belongs to it: give a number below 1`);
    rate = inverse(epsilon, ENDS[Number(at("measured-end").value)].epsilon) * Math.pow(velocity, -0.2);
  }
  const gStar = Math.pow(rate * theory.slope, -5);
  if (!(gStar > 0 && Number.isFinite(gStar))) throw new Error("the characteristic velocity is beyond the range of numbers: check the units");
  return { rate, gStar, bodies, unit, a: bodies ? rate / (1.5 * bodies.rate) : NaN };
}

// The elastic contact: rho, effective radius, mass and modulus.
function contact() {
  const young = positive("young", "Young's modulus") * 1e9;
  const poisson = read("poisson", "Poisson's ratio");
  const density = positive("density", "the density");
  const sphere = positive("radius", "the radius") * 1e-3;
  if (!(poisson > -1 && poisson <= 0.5)) throw new Error(`Poisson's ratio is ${poisson}: give a number greater than -1 and at most 1/2`);
  const against = at("against").value;
  const compliance = ((1 - poisson) * (1 + poisson)) / young;
  const half = against === "sphere";
  const radius = half ? sphere / 2 : sphere;
  const mass = ((4 / 3) * Math.PI * sphere ** 3 * density) / (half ? 2 : 1);
  const modulus = 1 / (against === "rigid-plane" ? compliance : 2 * compliance);
  const rho = (4 / 3) * modulus * Math.sqrt(radius);
  return { young, poisson, density, sphere, against, radius, mass, modulus, rho, rate: Math.pow(rho / mass, 0.4), sound: Math.sqrt(young / density) };
}

// The u at which a falling curve has the value epsilon, by bisection to the last bit.
function inverse(epsilon, curve) {
  let [low, high] = [0, 1];
  while (curve(high) > epsilon) [low, high] = [high, 2 * high];
  for (;;) {
    const middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return high;
    if (curve(middle) > epsilon) low = middle;
    else high = middle;
  }
}

// Duration and largest compression of x'' + u sqrt(x) x' + x^(3/2) = 0 by Taylor steps in z = sqrt(x), as the library's.
function course(u, end) {
  const ORDER = 24;
  if (!(u >= 0 && u <= 20)) return null;
  const product = (a, b, n) => {
    let sum = 0;
    for (let k = 0; k <= n; k++) sum += a[k] * b[n - k];
    return sum;
  };
  const reach = (c) => {
    const size = Math.max(Math.abs(c[0]), Math.abs(c[1]));
    let length = 1;
    for (let n = ORDER - 5; n <= ORDER; n++) {
      if (c[n] !== 0) length = Math.min(length, Math.pow((0.25 * Number.EPSILON * size) / Math.abs(c[n]), 1 / n));
    }
    return length;
  };
  const horner = (c, s) => c.reduceRight((sum, x) => sum * s + x, 0);
  let state = [0, 1, 0];
  let top = null;
  for (let count = 0; count < 100000; count++) {
    const [z, p, t, square, force] = Array.from({ length: 5 }, () => new Array(ORDER + 1).fill(0));
    [z[0], p[0], t[0]] = state;
    for (let n = 0; n < ORDER; n++) {
      square[n] = product(z, z, n);
      force[n] = u * p[n] + square[n];
      z[n + 1] = p[n] / (n + 1);
      p[n + 1] = (-2 * product(square, force, n)) / (n + 1);
      t[n + 1] = (2 * z[n]) / (n + 1);
    }
    const length = Math.min(reach(z), reach(p));
    const step = (s) => [horner(z, s), horner(p, s), horner(t, s)];
    const root = (distance) => {
      let [low, high] = [0, length];
      for (;;) {
        const middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) return high;
        if (distance(step(middle)) > 0) low = middle;
        else high = middle;
      }
    };
    const next = step(length);
    if (!top && next[1] > 0) {
      state = next;
      continue;
    }
    if (!top) top = step(root((s) => s[1]));
    const distance = (s) => (end === 1 && s[0] > 0 ? s[0] * s[0] + u * s[1] : s[0]);
    if (next[1] < 0 && distance(next) <= 0) {
      const exit = step(root((s) => (s[1] < 0 ? distance(s) : 1)));
      return { duration: exit[2], compression: top[0] * top[0] };
    }
    state = next;
  }
  return null;
}

// Formula (35) with the constants of Table I, as printed.
function printed(u) {
  const s = theory.slope * u;
  const [d1, d2, d3, d4, d5] = theory.printed;
  return (1 + d1 * s) / (1 + s * (d2 + s * (d3 + s * (d4 + s * d5))));
}

// ---- what is shown ----

let now = null; // the pair, or null while a field is wrong
let measured = []; // [velocity in m/s, epsilon]
let decades = [0, 0]; // the logarithms of the slowest and the fastest of them
let centre = null; // the velocity in the middle of the figure
let velocity = null; // the velocity that is read, m/s

function update() {
  const by = document.querySelector("input[name=by]:checked").value;
  for (const part of document.querySelectorAll("[data-by]")) part.hidden = !part.dataset.by.split(" ").includes(by);
  for (const field of document.querySelectorAll("[aria-invalid]")) field.removeAttribute("aria-invalid");
  try {
    now = pair();
    at("fault").textContent = "";
  } catch (error) {
    now = null;
    at("fault").textContent = error.message;
  }
  document.body.dataset.state = now ? "ready" : "fault";
  for (const part of ["figure", "validity-section", "codes-section"]) at(part).hidden = !now;
  if (!now) return;
  centre = middle();
  if (velocity === null) velocity = now.gStar;
  at("slider").value = String(Math.round(1000 * place(velocity)));
  draw();
  readout();
  validity();
  codes();
}

// The middle of the figure: that of the measurements, or where ε is about one half.
function middle() {
  return measured.length ? 10 ** (0.5 * (decades[0] + decades[1])) : now.gStar;
}

const span = () => {
  const far = measured.length ? Math.max(...decades.map((decade) => Math.abs(decade - Math.log10(centre)))) : 0;
  return Math.max(DECADES / 2, far + 0.2);
};
const place = (g) => Math.min(1, Math.max(0, 0.5 + Math.log10(g / centre) / (2 * span())));
const velocityAt = (share) => centre * 10 ** (2 * span() * (share - 0.5));

const HEIGHT = 360, LEFT = 34, RIGHT = 12, TOP = 10, BOTTOM = 40;
let width = 640; // of the figure, as wide as there is room, so that its letters keep their size
const across = (g) => LEFT + place(g) * (width - LEFT - RIGHT);
const down = (epsilon) => TOP + (1.05 - epsilon) / 1.05 * (HEIGHT - TOP - BOTTOM);

function line(curve, style) {
  const points = [];
  for (let k = 0; k <= 320; k++) {
    const g = velocityAt(k / 320);
    const epsilon = curve(now.rate * Math.pow(g, 0.2));
    if (epsilon <= 1.05 && epsilon >= 0) points.push(`${across(g).toFixed(1)},${down(epsilon).toFixed(1)}`);
  }
  return `<polyline class="${style}" points="${points.join(" ")}"/>`;
}

function draw() {
  width = Math.max(280, Math.round(at("plot").clientWidth) || 640);
  const parts = [];
  for (let tick = 0; tick <= 5; tick++) {
    const y = down(tick / 5).toFixed(1);
    parts.push(`<path class="grid" d="M${LEFT} ${y}H${width - RIGHT}"/><text x="${LEFT - 6}" y="${y}" dy="4" text-anchor="end">${tick / 5}</text>`);
  }
  const first = Math.ceil(Math.log10(velocityAt(0) / now.unit) - 1e-9);
  const last = Math.floor(Math.log10(velocityAt(1) / now.unit) + 1e-9);
  const every = Math.ceil((last - first + 1) / (width / 70));
  for (let power = first; power <= last; power += every) {
    const x = across(10 ** power * now.unit).toFixed(1);
    const label = Math.abs(power) < 4 ? text(10 ** power, 1) : `1e${power}`;
    parts.push(`<path class="grid" d="M${x} ${TOP}V${HEIGHT - BOTTOM}"/><text x="${x}" y="${HEIGHT - BOTTOM + 16}" text-anchor="middle">${label}</text>`);
  }
  const unit = at("unit").selectedOptions[0].textContent;
  parts.push(`<text x="${(LEFT + width - RIGHT) / 2}" y="${HEIGHT - 6}" text-anchor="middle">impact velocity g, ${unit}</text>`);
  parts.push(line(printed, "curve paper"));
  for (const end of ENDS) parts.push(line(end.epsilon, `curve ${end.style}`));
  parts.push(line((u) => (u > 1.5 ? theory.saturation / u ** 5 : NaN), "limit one"));
  for (const [g, epsilon] of drawn()) {
    if (epsilon <= 1.05) parts.push(`<circle class="datum" cx="${across(g).toFixed(1)}" cy="${down(epsilon).toFixed(1)}" r="3.5"/>`);
  }
  parts.push('<g id="cursor"></g>');
  at("plot").innerHTML = `<svg viewBox="0 0 ${width} ${HEIGHT}" role="img" aria-label="ε against impact velocity; the table below has the values">${parts.join("")}</svg>`;
  at("legend").innerHTML = `${ENDS.map((end) => `<span class="${end.style}">${end.name}</span>`).join("")}<span class="paper">formula (35) as printed</span><span class="one limit">law at unlimited velocity</span>`;
}

function row(name, ...cells) {
  const shown = cells.map((value) => `<td data-value="${value}">${text(value, 7)}</td>`);
  return `<tr><th scope="row">${name}</th>${shown.length === 1 ? shown[0].replace("<td", '<td colspan="2"') : shown.join("")}</tr>`;
}

// The values at the velocity that is read.
function readout() {
  const u = now.rate * Math.pow(velocity, 0.2);
  const field = at("velocity");
  if (document.activeElement !== field) field.value = text(velocity / now.unit, 8);
  const rows = [
    row("damping parameter u", u),
    row("ε", ...ENDS.map((end) => end.epsilon(u))),
    row("1 − ε", ...ENDS.map((end) => end.loss(u))),
    row("formula (35) as printed", printed(u)),
    row("law at unlimited velocity", u > 1.5 ? theory.saturation / u ** 5 : NaN, NaN),
  ];
  const courses = ENDS.map((_, end) => course(u, end));
  if (now.bodies) {
    const tau = 1 / (now.bodies.rate * Math.pow(velocity, 0.2));
    rows.push(row("duration of contact, s", ...courses.map((c) => (c ? tau * c.duration : NaN))));
    rows.push(row("largest compression, m", courses[0] ? velocity * tau * courses[0].compression : NaN));
  } else {
    rows.push(row("duration of contact, τ", ...courses.map((c) => (c ? c.duration : NaN))));
  }
  rows.push(row("g*, " + at("unit").selectedOptions[0].textContent, now.gStar / now.unit));
  at("readout").querySelector("tbody").innerHTML = rows.join("");
  const x = across(velocity).toFixed(1);
  const dots = ENDS.map((end) => `<circle class="dot ${end.style}" cx="${x}" cy="${down(end.epsilon(u)).toFixed(1)}" r="4"/>`);
  document.getElementById("cursor").innerHTML = `<path class="cursor" d="M${x} ${TOP}V${HEIGHT - BOTTOM}"/>${dots.join("")}`;
}

// The conditions of the quasi-static theory, at the velocity that is read.
function validity() {
  if (!now.bodies) {
    at("validity").querySelector("tbody").innerHTML = '<tr><td>Give the material to see its conditions.</td></tr>';
    return;
  }
  const u = now.rate * Math.pow(velocity, 0.2);
  const followed = course(u, 1);
  const tau = 1 / (now.bodies.rate * Math.pow(velocity, 0.2));
  const duration = tau * (followed ? followed.duration : theory.elastic_duration);
  const compression = velocity * tau * (followed ? followed.compression : theory.elastic_compression);
  const ratios = [
    ["velocity / speed of sound", velocity / now.bodies.sound],
    ["relaxation time A / duration", now.a / duration],
    ["contact radius / effective radius", Math.sqrt(compression / now.bodies.radius)],
  ];
  const verdict = (ratio) => (ratio < 0.1 ? "holds" : ratio <= 1 / 3 ? "doubtful" : "violated");
  at("validity").querySelector("tbody").innerHTML = ratios
    .map(([name, ratio]) => `<tr><th scope="row">${name}</th><td data-value="${ratio}">${text(ratio, 3)}</td><td class="${verdict(ratio)}">${verdict(ratio)}</td></tr>`)
    .join("");
}

// Input for simulation codes, SI units.
function codes() {
  const { bodies, a } = now;
  at("codes").innerHTML = "";
  at("codes-note").textContent = bodies
    ? "SI units; each line holds for this pair of bodies and says at which end of contact its code stops."
    : "Give the material: the codes need the stiffness.";
  if (!bodies) return;
  const kn = bodies.rho / Math.sqrt(bodies.radius);
  const eta = (1.5 * a * kn) / bodies.mass;
  const v = Math.sqrt(now.rate * Math.pow(velocity, 0.2));
  const polynomial = (c) => c.reduceRight((sum, x) => sum * v + x, 0);
  const en = polynomial(theory.yade[0]) / polynomial(theory.yade[1]);
  const plane = bodies.against !== "sphere";
  const hertz = `hertz ${text(kn, 8)} ${text(eta, 8)} tangential linear_nohistory 0 0 damping viscoelastic`;
  const lines = [
    ["LAMMPS, zero compression", plane ? `fix wall all wall/gran granular ${hertz} zplane 0 NULL` : `pair_style granular\npair_coeff * * ${hertz}`],
    ["LAMMPS, zero force", plane ? `fix wall all wall/gran granular ${hertz} limit_damping zplane 0 NULL` : `pair_style granular\npair_coeff * * ${hertz} limit_damping`],
    ["MercuryDPM, HertzianBSHPViscoelastic, zero force", `species->setEffectiveElasticModulus(${text(bodies.modulus, 8)});\nspecies->setDissipation(${text(a, 8)});`],
    ["ESyS-Particle, zero force", `HertzianViscoElasticPrms(name="contact", A=${text(1.5 * a, 8)}, E=${text(bodies.young, 8)}, nu=${text(bodies.poisson, 8)})`],
    ["YADE from 2023.02a, zero force", `Ip2_FrictMat_FrictMat_MindlinPhys(en=${text(en, 8)}, vn=${text(velocity, 8)})`],
  ];
  for (const [name, source] of lines) {
    const box = document.createElement("div");
    box.className = "code";
    box.innerHTML = '<strong></strong> <button type="button">Copy</button><pre tabindex="0"></pre>';
    box.querySelector("strong").textContent = name;
    box.querySelector("pre").textContent = source;
    box.querySelector("button").addEventListener("click", (event) => copy(source, event.target));
    at("codes").append(box);
  }
}

async function copy(source, button) {
  try {
    await navigator.clipboard.writeText(source);
  } catch {
    const area = document.createElement("textarea"); // pages from files have no clipboard of their own
    area.value = source;
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
  button.textContent = "Copied";
  setTimeout(() => (button.textContent = "Copy"), 1500);
}

// ---- measurements ----

const least = (numbers) => numbers.reduce((a, b) => Math.min(a, b), Infinity);
const most = (numbers) => -least(numbers.map((number) => -number));

// The measurements in m/s, and the decades they lie in.
function take(rows) {
  measured = rows;
  const logs = rows.map(([g]) => Math.log10(g));
  decades = [least(logs), most(logs)];
}

// As many as a figure can show: every n-th of a long file.
function drawn() {
  const every = Math.ceil(measured.length / DRAWN);
  return measured.filter((_, k) => k % every === 0);
}

// The size of the unit that the head of the velocities names, if it names one.
function namedUnit(head) {
  const unit = /(?:^|[^a-zµ])(mm|cm|m)(?:\s*\/\s*s|[\s·]+s\s*(?:\^?-1|⁻¹))(?![a-z])/i.exec(head);
  return unit && { m: 1, cm: 0.01, mm: 0.001 }[unit[1].toLowerCase()];
}

// Reads two columns of numbers; returns the rows, the unit that their head names, and how many lines were no rows.
function columns(content) {
  const rows = [];
  let others = 0;
  let unit = null;
  let first = true; // a first line without numbers names the columns
  for (const raw of content.replace(/^\uFEFF/, "").split(/\r\n|\r|\n/)) {
    const entry = raw.replace(/[#%].*/, "").trim();
    if (!entry) continue;
    const separator = entry.includes(";") ? ";" : entry.includes("\t") ? "\t" : entry.includes(",") && !/^\S+\s+\S+$/.test(entry) ? "," : /\s+|,/;
    const cells = entry.split(separator);
    const words = cells.map((word) => parse(word.trim().replace(/^"(.*)"$/, "$1")));
    if (words.length >= 2 && words[0] > 1e-100 && words[0] < 1e100 && words[1] > 0 && words[1] <= 2) rows.push([words[0], words[1]]);
    else if (!first || words.some((word) => !Number.isNaN(word))) others += 1;
    else unit = namedUnit(cells[0]) ?? namedUnit(entry);
    first = false;
  }
  return { rows, unit, others };
}

async function load(file) {
  const note = at("data-note");
  if (file.size > 20e6) {
    note.textContent = `${file.name} has ${Math.round(file.size / 1e6)} MB: use 'restitution fit' for files above 20 MB`;
    return;
  }
  const { rows, unit, others } = columns(await file.text());
  const size = unit ?? Number(at("unit").value);
  take(rows.map(([g, epsilon]) => [g * size, epsilon]));
  const chosen = [...at("unit").options].find((option) => Number(option.value) === size).textContent;
  const taken = unit === null ? `velocities taken in ${chosen}` : `velocities in ${chosen}, as it says`;
  note.textContent = rows.length
    ? `${file.name}: ${rows.length} ${rows.length === 1 ? "row" : "rows"}, ${taken}${others ? `; lines that are no pair of a velocity and an ε: ${others}` : ""}`
    : `${file.name} has no line with a velocity and an ε (above 0 and at most 2): two columns of numbers are needed`;
  at("fit").disabled = measured.length < 2;
  at("clear").disabled = !measured.length;
  update();
}

// g* by least squares in ε, at the end of contact chosen for measurements.
function fitted() {
  const curve = ENDS[Number(at("measured-end").value)].epsilon;
  const roots = measured.map(([g]) => Math.pow(g, 0.2));
  const loss = (log) => {
    let sum = 0;
    measured.forEach(([, epsilon], k) => (sum += (epsilon - curve(Math.exp(log) * roots[k])) ** 2));
    return sum;
  };
  const asked = measured.filter(([, epsilon]) => epsilon < 1).map(([g, epsilon]) => Math.log(inverse(epsilon, curve) / Math.pow(g, 0.2)));
  if (!asked.length) return NaN;
  const [first, last] = [least(asked) - 1e-6, most(asked) + 1e-6];
  let best = first;
  for (let k = 0; k <= 64; k++) {
    const point = first + ((last - first) * k) / 64;
    if (loss(point) < loss(best)) best = point;
  }
  const golden = 0.5 * (Math.sqrt(5) - 1);
  let [low, high] = [best - (last - first) / 64, best + (last - first) / 64];
  for (let k = 0; k < 80; k++) {
    const [a, b] = [high - golden * (high - low), low + golden * (high - low)];
    if (loss(a) <= loss(b)) high = b;
    else low = a;
  }
  return Math.exp(-5 * (Math.log(theory.slope) + 0.5 * (low + high)));
}

// ---- events ----

for (const name of Object.keys(EXAMPLES)) at("example").add(new Option(name, name));
at("example").addEventListener("change", (event) => {
  const example = EXAMPLES[event.target.value];
  if (example) ["young", "poisson", "density"].forEach((id, k) => (at(id).value = example[k]));
});
at("bodies").addEventListener("submit", (event) => event.preventDefault());
for (const kind of ["input", "change"]) {
  at("bodies").addEventListener(kind, () => {
    velocity = null;
    update();
  });
}

function look(g) {
  velocity = g;
  at("slider").value = String(Math.round(1000 * place(g)));
  readout();
  validity();
  codes();
}

at("slider").addEventListener("input", (event) => {
  look(velocityAt(Number(event.target.value) / 1000));
});
at("velocity").addEventListener("input", () => {
  const value = parse(at("velocity").value);
  const good = value > 0 && Number.isFinite(value);
  at("velocity").setAttribute("aria-invalid", String(!good));
  if (good && now) look(value * now.unit);
});
function pointed(event) {
  if (!now || (event.pointerType !== "mouse" && event.buttons === 0 && event.type !== "pointerdown")) return;
  const box = at("plot").getBoundingClientRect();
  const share = (((event.clientX - box.left) / box.width) * width - LEFT) / (width - LEFT - RIGHT);
  look(velocityAt(Math.min(1, Math.max(0, share))));
}
for (const kind of ["pointermove", "pointerdown"]) at("plot").addEventListener(kind, pointed);

at("file").addEventListener("change", (event) => {
  if (event.target.files.length) load(event.target.files[0]);
});
for (const kind of ["dragenter", "dragover"]) {
  document.addEventListener(kind, (event) => {
    event.preventDefault();
    at("drop").classList.add("over");
  });
}
document.addEventListener("dragleave", () => at("drop").classList.remove("over"));
document.addEventListener("drop", (event) => {
  event.preventDefault();
  at("drop").classList.remove("over");
  if (event.dataTransfer.files.length) load(event.dataTransfer.files[0]);
});
at("clear").addEventListener("click", () => {
  take([]);
  at("file").value = "";
  at("data-note").textContent = "";
  at("fit").disabled = at("clear").disabled = true;
  update();
});
at("fit").addEventListener("click", () => {
  const gStar = fitted();
  if (!(gStar > 0 && Number.isFinite(gStar))) {
    at("data-note").textContent = "no damping can be seen in these measurements: none has an ε below 1";
    return;
  }
  document.querySelector("input[name=by][value=g-star]").checked = true;
  at("g-star").value = text(gStar / Number(at("unit").value), 12);
  velocity = null;
  update();
  at("data-note").textContent = `g* = ${text(gStar / now.unit, 6)} ${at("unit").selectedOptions[0].textContent} by least squares in ε; 'restitution fit' gives its error and says whether the law fits`;
});
window.addEventListener("resize", () => {
  if (now && Math.abs(width - at("plot").clientWidth) > 1) update();
});
update();
