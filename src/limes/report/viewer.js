// Turns every .view3d of the page into a model that can be turned: drag to orbit, shift-drag to move,
// wheel to zoom once the view was clicked, arrow keys and + - too. Without WebGL 2 the still picture
// stays. Data: base64 of little-endian arrays, made by view3d.cpp.
"use strict";
(() => {
  const vertexShader = `#version 300 es
    in vec3 position; in vec3 normal; in float light; in vec3 colour;
    uniform mat3 turn; uniform vec3 shift; uniform vec4 lens; uniform float nearer;
    out vec3 n; out vec3 c; flat out int kind;
    void main() {
      vec3 p = (turn * position + shift) * nearer;      // along the ray: only the depth changes
      n = turn * normal; c = colour; kind = int(light);
      gl_Position = vec4(lens.x * p.x, lens.y * p.y, lens.z * p.z + lens.w, -p.z);
    }`;
  // The same lights as in the still pictures (raster_shader.h). Kind 0: none, also without a normal;
  // 1: the faint shading of fields; 2: lit.
  const fragmentShader = `#version 300 es
    precision highp float;
    in vec3 n; in vec3 c; flat in int kind; out vec4 colour;
    void main() {
      if (kind == 0 || dot(n, n) == 0.0) { colour = vec4(c, 1.0); return; }
      vec3 m = normalize(n) * (gl_FrontFacing ? 1.0 : -1.0);
      if (kind == 1) { colour = vec4(c * (0.94 + 0.06 * max(0.0, m.z)), 1.0); return; }
      float wrapped = max(0.0, 0.25 + 0.75 * dot(m, vec3(-0.466, 0.577, 0.671)));
      float light = 0.22 + 0.62 * wrapped * wrapped + 0.18 * max(0.0, dot(m, vec3(0.883, 0.052, 0.467)))
                  + 0.18 * max(0.0, m.z);
      float shine = 0.08 * pow(max(0.0, dot(m, vec3(-0.255, 0.316, 0.914))), 32.0);
      colour = vec4(sqrt(c * c * light + shine), 1.0);
    }`;

  function decode(view, name, Type) {
    const text = atob(view.querySelector(`script[data-name="${name}"]`).textContent);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    return new Type(bytes.buffer);
  }

  function link(gl) {
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    return gl.getProgramParameter(program, gl.LINK_STATUS) ? program : null;
  }

  // One mesh on the graphics card: attributes per point, indices of triangles or lines.
  function upload(gl, program, view, kind, hasNormals) {
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const buffer = data => {
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    };
    const attribute = (name, size, type, normalised, stride, offset) => {   // in the buffer made last
      const at = gl.getAttribLocation(program, name);
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, size, type, normalised, stride, offset);
    };
    buffer(decode(view, kind + "-points", Float32Array));
    attribute("position", 3, gl.FLOAT, false, 0, 0);
    buffer(decode(view, kind + "-colours", Uint8Array));
    attribute("colour", 3, gl.UNSIGNED_BYTE, true, 0, 0);
    if (hasNormals) {                                     // else there is no light
      buffer(decode(view, kind + "-normals", Int8Array));
      attribute("normal", 3, gl.BYTE, true, 4, 0);
      attribute("light", 1, gl.BYTE, false, 4, 3);
    }
    const indices = decode(view, kind + "-indices", Uint32Array);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
    return {array, count: indices.length};
  }

  // 3 x 3 matrices as rows; the model's axes in the camera's frame (right, up, towards the eye).
  const multiply = (a, b) => a.map(row => [0, 1, 2].map(j => row[0] * b[0][j] + row[1] * b[1][j] + row[2] * b[2][j]));
  function rotation(axis, angle) {
    const c = Math.cos(angle), s = Math.sin(angle);
    return axis === "x" ? [[1, 0, 0], [0, c, -s], [0, s, c]] : [[c, 0, s], [0, 1, 0], [-s, 0, c]];
  }

  // x, y, z in the lower left corner, as beside the still pictures (axes_triad.cpp); returns what turns them.
  function addTriad(view, canvas) {
    const axis = (name, colour) => `<line stroke="${colour}"/><text fill="${colour}">${name}</text>`;
    view.insertAdjacentHTML("beforeend", `<svg class="triad" viewBox="-45 -45 90 90">
      ${view.dataset.axisColours.split(" ").map((colour, i) => axis("xyz"[i], colour)).join("")}</svg>`);
    const svg = view.querySelector(".triad"), lines = svg.querySelectorAll("line"), labels = svg.querySelectorAll("text");
    return turn => {
      svg.style.top = `${canvas.offsetTop + canvas.clientHeight - 96}px`;
      const at = [0, 1, 2].map(i => {
        const x = 28 * turn[0][i], y = -28 * turn[1][i], length = Math.hypot(x, y);
        lines[i].setAttribute("x2", x);
        lines[i].setAttribute("y2", y);
        const out = 1 + 10 / length;                      // along the line of sight: the letter beside the middle
        return length > 4 ? [out * x, out * y] : [10, -10];
      });
      const order = [0, 1, 2].sort((i, j) => turn[2][j] - turn[2][i]);   // the nearest end first
      for (let i = 1; i < 3; ++i)
        for (let j = 0; j < i; ++j) {                     // of two letters on each other the farther one moves out
          const [x, y] = at[order[i]], nearer = at[order[j]];
          if (Math.hypot(x - nearer[0], y - nearer[1]) >= 13) continue;
          const out = (Math.hypot(...nearer) + 13) / Math.hypot(x, y);
          at[order[i]] = [out * x, out * y];
        }
      at.forEach(([x, y], i) => {
        labels[i].setAttribute("x", x);
        labels[i].setAttribute("y", y + 4);
      });
    };
  }

  function start(view) {
    const canvas = view.querySelector("canvas");
    const gl = canvas.getContext("webgl2", {antialias: true});
    const program = gl && link(gl);
    if (!program) return;
    const triangles = upload(gl, program, view, "surface", true);
    const lines = upload(gl, program, view, "lines", false);
    const slope = Number(view.dataset.slope);           // tangent of half the opening angle
    const home = JSON.parse(view.dataset.axes);
    const edges = view.querySelector("input");
    const turnTriad = addTriad(view, canvas);
    let axes, distance, pan;
    const reset = () => { axes = home; distance = 1.04 / Math.sin(Math.atan(slope)); pan = [0, 0]; };

    const draw = () => {
      turnTriad(axes);
      const ratio = window.devicePixelRatio || 1;
      canvas.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
      canvas.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
      const narrow = Math.min(1, canvas.width / canvas.height);
      const near = Math.max(distance - 1.5, 0.02), far = distance + 1.5;
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clearColor(1, 1, 1, 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.DEPTH_TEST);
      gl.useProgram(program);
      gl.uniformMatrix3fv(gl.getUniformLocation(program, "turn"), true, axes.flat());
      gl.uniform3f(gl.getUniformLocation(program, "shift"), pan[0], pan[1], -distance);
      gl.uniform4f(gl.getUniformLocation(program, "lens"), narrow / slope * canvas.height / canvas.width,
                   narrow / slope, (near + far) / (near - far), 2 * near * far / (near - far));
      gl.uniform1f(gl.getUniformLocation(program, "nearer"), 1);
      gl.bindVertexArray(triangles.array);
      gl.drawElements(gl.TRIANGLES, triangles.count, gl.UNSIGNED_INT, 0);
      if (!edges.checked) return;
      gl.uniform1f(gl.getUniformLocation(program, "nearer"), 0.999);   // edges win against their faces
      gl.bindVertexArray(lines.array);
      gl.drawElements(gl.LINES, lines.count, gl.UNSIGNED_INT, 0);
    };
    let waiting = false;
    const redraw = () => {
      if (!waiting) requestAnimationFrame(() => { waiting = false; draw(); });
      waiting = true;
    };
    const orbit = (dx, dy) => { axes = multiply(multiply(rotation("x", dy), rotation("y", dx)), axes); redraw(); };
    const zoom = factor => { distance = Math.min(60, Math.max(0.4, distance * factor)); redraw(); };

    const pointers = new Map();
    canvas.addEventListener("pointerdown", e => {
      canvas.setPointerCapture(e.pointerId);
      pointers.set(e.pointerId, [e.clientX, e.clientY]);
    });
    canvas.addEventListener("pointermove", e => {
      if (!pointers.has(e.pointerId)) return;
      const spread = () => { const [p, q] = [...pointers.values()]; return Math.hypot(p[0] - q[0], p[1] - q[1]); };
      const before = pointers.size === 2 ? spread() : 0;
      const old = pointers.get(e.pointerId);
      pointers.set(e.pointerId, [e.clientX, e.clientY]);
      const dx = e.clientX - old[0], dy = e.clientY - old[1];
      if (pointers.size === 2) { zoom(before / Math.max(1, spread())); return; }
      if (!e.shiftKey) { orbit(dx * 0.008, dy * 0.008); return; }
      const scale = 2 * distance * slope / canvas.clientHeight;
      pan = [pan[0] + dx * scale, pan[1] - dy * scale];
      redraw();
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, e => pointers.delete(e.pointerId));
    canvas.addEventListener("wheel", e => {
      if (document.activeElement !== canvas) return;    // else the page scrolls
      e.preventDefault();
      zoom(Math.exp(e.deltaY * 0.001));
    }, {passive: false});
    const keys = {ArrowLeft: () => orbit(-0.1, 0), ArrowRight: () => orbit(0.1, 0), ArrowUp: () => orbit(0, -0.1),
                  ArrowDown: () => orbit(0, 0.1), "+": () => zoom(0.9), "-": () => zoom(1.1)};
    canvas.addEventListener("keydown", e => {
      if (!keys[e.key]) return;
      e.preventDefault();
      keys[e.key]();
    });
    edges.addEventListener("change", redraw);
    view.querySelector("button").addEventListener("click", () => { reset(); redraw(); });
    new ResizeObserver(redraw).observe(canvas);
    reset();
    view.classList.add("live");
    draw();
  }
  document.querySelectorAll(".view3d").forEach(start);
})();
