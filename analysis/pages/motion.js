// Plays the motion of one run (mc/run/motion_frames.hpp): play_motion(element, motion) fills the element with the bearing seen
// along its axis, the orbit of the cage's centre, bar forces and stress over time. Needs nothing but a browser.
"use strict";

function play_motion(element, motion) {
  const g = motion.geometry, frames = motion.time_ms.length, rollers = g.rollers;
  const blue = "#0072B2", orange = "#D55E00", green = "#009E73", grey = "#8a8a8a", light = "#dcdcdc", ink = "#222222";
  const radian = Math.PI / 180;
  const most = values => values.reduce((a, b) => Math.max(a, b || 0), 0);
  const race_most = most(motion.race_force_N) || 1;
  const bar_most = Math.max(most(motion.leading_force_N), most(motion.trailing_force_N)) || 1;
  // Clearances are drawn so many times as large: a pocket's becomes a tenth of a roller's diameter.
  const diameter = 2 * g.roller_radius_mm[0];
  const clearance = Math.max(most(g.pocket_clearance_um), 1);
  const factor = Math.max(1, Math.round(0.15 * diameter * 1000 / clearance));

  element.classList.add("motion");
  element.innerHTML =
    '<div class="motion-views"><canvas class="motion-bearing" width="880" height="880"></canvas>' +
    '<div><canvas class="motion-orbit" width="640" height="440"></canvas>' +
    '<canvas class="motion-traces" width="640" height="440"></canvas></div></div>' +
    '<div class="motion-controls"><button type="button">Pause</button>' +
    '<input type="range" min="0" max="' + (frames - 1) + '" value="0" aria-label="instant"><output></output></div>';
  const [bearing, orbit, traces] = element.querySelectorAll("canvas");
  const button = element.querySelector("button"), slider = element.querySelector("input"), said = element.querySelector("output");

  function circle(c, x, y, r, stroke, fill, width) {
    c.beginPath(); c.arc(x, y, r, 0, 2 * Math.PI);
    if (fill) { c.fillStyle = fill; c.fill(); }
    if (stroke) { c.strokeStyle = stroke; c.lineWidth = width || 2; c.stroke(); }
  }
  function text(c, words, x, y, align, colour) {
    c.fillStyle = colour || ink; c.font = "22px 'DejaVu Sans', sans-serif"; c.textAlign = align || "left";
    c.fillText(words, x, y);
  }
  function shade(share) { // white to blue
    const part = Math.sqrt(Math.min(1, Math.max(0, share)));
    const mix = (from, to) => Math.round(from + (to - from) * part);
    return "rgb(" + mix(255, 0) + "," + mix(255, 114) + "," + mix(255, 178) + ")";
  }

  function draw_bearing(k) {
    const c = bearing.getContext("2d"), size = bearing.width, scale = 0.44 * size / (g.outer_race_radius_mm + 0.06 * diameter);
    c.clearRect(0, 0, size, size);
    const x0 = size / 2, y0 = size / 2 + 14;
    const at = (radius, angle, y, z) => [x0 + scale * (radius * Math.cos(angle) + y), y0 - scale * (radius * Math.sin(angle) + z)];
    circle(c, x0, y0, scale * g.outer_race_radius_mm, ink, null, 3);
    circle(c, x0, y0, scale * g.inner_race_radius_mm, ink, "#f4f4f4", 3);
    const mark = motion.inner_angle_deg[k] * radian;
    c.beginPath(); c.moveTo(...at(0.8 * g.inner_race_radius_mm, mark, 0, 0)); c.lineTo(...at(g.inner_race_radius_mm, mark, 0, 0));
    c.lineWidth = 4; c.strokeStyle = ink; c.stroke();
    const turn = motion.cage_angle_deg[k] * radian, y = factor * motion.cage_y_um[k] / 1000;
    const z = factor * motion.cage_z_um[k] / 1000;
    const face = (j, ahead, radius) => { // of a bar, ahead of or behind the roller
      const pocket = turn + g.pocket_angle_deg[j] * radian, way = ahead ? 1 : -1;
      const offset = way * (g.roller_radius_mm[j] + factor * g.pocket_clearance_um[j] / 2000);
      return at(radius, pocket, y - offset * Math.sin(pocket), z + offset * Math.cos(pocket));
    };
    for (let j = 0; j < rollers; ++j) { // bars, from one pocket to the next
      const next = (j + 1) % rollers, inner = g.cage_inner_radius_mm, outer = g.cage_outer_radius_mm;
      c.beginPath();
      for (const corner of [face(j, true, inner), face(j, true, outer), face(next, false, outer), face(next, false, inner)])
        c.lineTo(...corner);
      c.closePath(); c.fillStyle = "#cfeade"; c.fill();
    }
    for (let j = 0; j < rollers; ++j) {
      const i = k * rollers + j, pocket = turn + g.pocket_angle_deg[j] * radian, radius = g.roller_radius_mm[j];
      const place = factor * motion.place_um[i] / 1000;
      const [rx, ry] = at(g.pitch_radius_mm, pocket + place / g.pitch_radius_mm, 0, 0);
      circle(c, rx, ry, scale * radius, grey, shade(motion.race_force_N[i] / race_most), 2);
      for (const [ahead, force] of [[true, motion.leading_force_N[i]], [false, motion.trailing_force_N[i]]]) {
        c.beginPath(); c.moveTo(...face(j, ahead, g.cage_inner_radius_mm)); c.lineTo(...face(j, ahead, g.cage_outer_radius_mm));
        c.strokeStyle = force > 0 ? orange : green; c.lineWidth = 3 + 9 * Math.sqrt(force / bar_most); c.stroke();
      }
    }
    const [cx, cy] = at(0, 0, y, z);
    circle(c, cx, cy, scale * g.cage_inner_radius_mm, green, null, 1);
    circle(c, cx, cy, scale * g.cage_outer_radius_mm, green, null, 1);
    circle(c, cx, cy, 5, null, green);
    circle(c, x0, y0, 3, null, ink);
    text(c, "Clearances " + factor + " times as large", 8, 26);
    text(c, "roller on race, up to " + race_most.toPrecision(3) + " N", 8, size - 38, "left", blue);
    text(c, "bars: orange where pressed, up to " + bar_most.toPrecision(3) + " N", 8, size - 10, "left", orange);
  }

  function draw_orbit(k) {
    const c = orbit.getContext("2d"), width = orbit.width, height = orbit.height;
    c.clearRect(0, 0, width, height);
    const reach = Math.max(g.guide_clearance_um, most(motion.cage_y_um.map(Math.abs)), most(motion.cage_z_um.map(Math.abs)));
    const x0 = width / 2, y0 = height / 2 + 14, scale = 0.43 * (height - 30) / reach;
    const point = i => [x0 + scale * motion.cage_y_um[i], y0 - scale * motion.cage_z_um[i]];
    circle(c, x0, y0, scale * g.guide_clearance_um, grey, null, 2);
    const trail = (from, to, colour, line) => {
      c.beginPath();
      for (let i = from; i <= to; ++i) c.lineTo(...point(i));
      c.strokeStyle = colour; c.lineWidth = line; c.stroke();
    };
    trail(0, frames - 1, light, 2);
    trail(Math.max(0, k - 40), k, green, 3);
    circle(c, ...point(k), 8, null, green);
    circle(c, x0, y0, 3, null, ink);
    text(c, "Cage centre", 8, 26);
    text(c, "guide clearance " + g.guide_clearance_um.toPrecision(3) + " um, radial", 8, height - 10, "left", grey);
  }

  const bar_force = motion.time_ms.map((_, k) => {
    let largest = 0;
    for (let j = 0; j < rollers; ++j)
      largest = Math.max(largest, motion.leading_force_N[k * rollers + j], motion.trailing_force_N[k * rollers + j]);
    return largest;
  });
  const curves = [["largest bar force [N]", bar_force, orange]];
  if (motion.cage_stress_MPa) curves.push(["cage stress [MPa]", motion.cage_stress_MPa, blue]);
  function draw_traces(k) {
    const c = traces.getContext("2d"), width = traces.width, height = traces.height, each = (height - 30) / curves.length;
    c.clearRect(0, 0, width, height);
    const first = motion.time_ms[0], span = motion.time_ms[frames - 1] - first || 1;
    const x = i => 10 + (width - 20) * (motion.time_ms[i] - first) / span;
    curves.forEach(([words, values, colour], n) => {
      const base = (n + 1) * each, top = most(values) || 1;
      c.beginPath(); c.moveTo(10, base); c.lineTo(width - 10, base); c.strokeStyle = light; c.lineWidth = 2; c.stroke();
      c.beginPath();
      values.forEach((value, i) => c.lineTo(x(i), base - (each - 46) * (value || 0) / top));
      c.strokeStyle = colour; c.lineWidth = 2; c.stroke();
      text(c, words + ": " + (values[k] || 0).toPrecision(3) + ", up to " + top.toPrecision(3), 10, base - each + 30, "left", colour);
    });
    c.beginPath(); c.moveTo(x(k), 0); c.lineTo(x(k), height - 30); c.strokeStyle = grey; c.lineWidth = 1; c.stroke();
    text(c, first.toPrecision(4) + " ms", 10, height - 4, "left", grey);
    text(c, (first + span).toPrecision(4) + " ms", width - 10, height - 4, "right", grey);
  }

  let frame = 0, playing = true;
  function show(k) {
    frame = k;
    slider.value = k;
    said.textContent = motion.time_ms[k].toFixed(2) + " ms";
    element.dataset.frame = k;
    draw_bearing(k); draw_orbit(k); draw_traces(k);
  }
  button.onclick = () => { playing = !playing; button.textContent = playing ? "Pause" : "Play"; };
  slider.oninput = () => { playing = false; button.textContent = "Play"; show(Number(slider.value)); };
  show(0);
  window.setInterval(() => { if (playing && element.offsetParent !== null) show((frame + 1) % frames); }, 40);
}
