"use strict";
// Each figure shows what its lines and marks have at the pointer, or where the arrow keys have moved: read off the drawing, so
// to two digits. The files beside the page have the data.

// `log low high from to`: the scale, its ends, and where in the drawing they lie.
function axis(described) {
  const [scale, ...numbers] = described.split(" ");
  const [low, high, from, to] = numbers.map(Number);
  return (place) => {
    const value = low + ((place - from) / (to - from)) * (high - low);
    const shown = scale === "log" ? 10 ** value : value;
    const digits = scale === "log" ? 2 : 3;
    const large = Math.abs(shown) >= 1e5 || (shown !== 0 && Math.abs(shown) < 1e-3);
    const written = large ? shown.toExponential(digits - 1) : String(Number(shown.toPrecision(digits)));
    return written.replace("+", "").replaceAll("-", "−");
  };
}

function pointsOf(drawn) {
  const pairs = drawn.match(/-?[\d.]+ -?[\d.]+/g) || [];
  return pairs.map((pair) => pair.split(" ").map(Number));
}

// The drawn height of a line at x; undefined where it isn't drawn.
function heightAt(pieces, x) {
  for (const points of pieces) {
    const next = points.findIndex(([a]) => a >= x);
    if (next < 0 || (next === 0 && points[0][0] > x + 0.5)) continue;
    const [[a, b], [c, d]] = [points[Math.max(0, next - 1)], points[next]];
    return c > a ? b + ((d - b) * (x - a)) / (c - a) : d;
  }
  return undefined;
}

for (const svg of document.querySelectorAll("svg.chart")) {
  const [xAxis, yAxis] = [axis(svg.dataset.x), axis(svg.dataset.y)];
  const [left, right, top, bottom] = svg.dataset.area.split(" ").map(Number);
  const lines = [...svg.querySelectorAll(".line[data-name]")].map((path) => ({
    path,
    pieces: path.getAttribute("d").split("M").map(pointsOf),
  }));
  const marks = [...svg.querySelectorAll(".mark")].filter((mark) => mark.textContent);
  const places = marks.map((mark) => pointsOf(mark.getAttribute("d"))[0]);
  const guide = document.createElementNS(svg.namespaceURI, "path");
  guide.setAttribute("class", "guide");
  svg.append(guide);
  const box = document.createElement("div");
  box.className = "reading";
  box.setAttribute("role", "status");
  box.hidden = true;
  svg.after(box);
  svg.setAttribute("tabindex", "0");
  let at = (left + right) / 2;

  const row = (text, from) => {
    const shown = document.createElement("div");
    if (from) shown.className = from.getAttribute("class");
    shown.textContent = text;
    box.append(shown);
  };

  function hide() {
    box.hidden = true;
    guide.setAttribute("d", "");
  }

  // What is at (x, y): a mark, else every line at that x.
  function read(x, y) {
    box.textContent = "";
    const near = places.map(([a, b]) => Math.hypot(a - x, b - y));
    const mark = near.indexOf(Math.min(...near));
    if (mark >= 0 && near[mark] < 12) {
      guide.setAttribute("d", "");
      row(marks[mark].textContent, marks[mark]);
    } else {
      const there = lines.map(({ path, pieces }) => ({ path, height: heightAt(pieces, x) }));
      const seen = there.filter(({ height }) => height >= top - 1 && height <= bottom + 1);
      if (!seen.length) return hide();
      guide.setAttribute("d", `M${x} ${top}V${bottom}`);
      row(`${svg.dataset.across} ≈ ${xAxis(x)}`);
      seen.sort((a, b) => a.height - b.height);
      for (const { path, height } of seen) row(`${path.dataset.name}: ${yAxis(height)}`, path);
    }
    box.hidden = false;
    const share = x / svg.viewBox.baseVal.width;
    box.style.left = share < 0.4 ? `${100 * share + 3}%` : "";
    box.style.right = share < 0.4 ? "" : `${100 * (1 - share) + 3}%`;
  }

  svg.addEventListener("pointermove", (event) => {
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    at = Math.min(right, Math.max(left, x));
    if (x < left - 5 || x > right + 5 || y < top - 5 || y > bottom + 5) hide();
    else read(at, y);
  });
  svg.addEventListener("pointerleave", hide);
  svg.addEventListener("blur", hide);
  svg.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (event.key === "Escape") hide();
    if (!step) return;
    event.preventDefault();
    const stops = lines.length ? lines.flatMap(({ pieces }) => pieces.flat()) : places;
    const beyond = stops.filter(([x]) => step * (x - at) > (lines.length ? 2 : 0.01)).map(([x]) => x);
    if (beyond.length) at = step > 0 ? Math.min(...beyond) : Math.max(...beyond);
    const mark = places.find(([x]) => x === at);
    read(at, mark && !lines.length ? mark[1] : -1e9);
  });
}
