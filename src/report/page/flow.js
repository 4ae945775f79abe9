// Flow diagrams: nodes in columns, ribbons as wide as what they carry.

pmr.energy = function (joule) {
  var steps = [
      [1e6, "MJ"],
      [1e3, "kJ"],
      [1, "J"],
      [1e-3, "mJ"]
    ],
    shown = Number(joule.toPrecision(3)),
    size = Math.abs(shown);
  var step = steps.filter((s) => size >= s[0])[0] || steps[3];
  return (
    d3
      .format(".3r")(shown / step[0])
      .replace("-", "−") +
    " " +
    step[1]
  );
};

// Node values, and where each stands; the tallest column fills `height`.
pmr.flow_layout = function (spec, height) {
  var nodes = {},
    gap = 30;
  spec.nodes.forEach(function (n) {
    nodes[n.id] = { node: n, into: 0, out: 0, top: 0 };
  });
  spec.links.forEach(function (l) {
    nodes[l.from].out += l.value;
    nodes[l.to].into += l.value;
  });
  var used = spec.nodes.map((n) => nodes[n.id]).filter((n) => n.into + n.out > 0);
  used.forEach(function (n) {
    n.value = Math.max(n.into, n.out);
  });
  var columns = d3
    .nest()
    .key((n) => n.node.column)
    .entries(used);
  var scale = d3.min(columns, function (c) {
    return (height - gap * (c.values.length - 1)) / d3.sum(c.values, (n) => n.value);
  });
  columns.forEach(function (c) {
    var y = 0;
    c.values.forEach(function (n) {
      n.y = y;
      n.height = n.value * scale;
      n.from = n.to = y;
      y += n.height + gap;
    });
  });
  return { nodes: nodes, used: used, scale: scale };
};

pmr.ribbon = function (x0, y0, x1, y1, thickness) {
  var middle = (x0 + x1) / 2;
  return (
    "M" +
    x0 +
    "," +
    y0 +
    "C" +
    middle +
    "," +
    y0 +
    " " +
    middle +
    "," +
    y1 +
    " " +
    x1 +
    "," +
    y1 +
    "v" +
    thickness +
    "C" +
    middle +
    "," +
    (y1 + thickness) +
    " " +
    middle +
    "," +
    (y0 + thickness) +
    " " +
    x0 +
    "," +
    (y0 + thickness) +
    "Z"
  );
};

pmr.draw_flow = function (holder, spec, width) {
  var narrow = width < 620,
    left = 6,
    right = narrow ? 112 : 170,
    bar = 14,
    height = narrow ? 240 : 290,
    top = 34;
  var layout = pmr.flow_layout(spec, height),
    total = d3.sum(layout.used, (n) => (n.node.column === 0 ? n.out : 0));
  var svg = holder
    .append("svg")
    .attr("viewBox", "0 0 " + width + " " + (height + top + 36))
    .append("g")
    .attr("transform", "translate(" + left + "," + top + ")");
  var last = d3.max(layout.used, (n) => n.node.column);
  function x(n) {
    return (n.node.column / last) * (width - left - right - bar);
  }
  spec.links.forEach(function (l) {
    var a = layout.nodes[l.from],
      b = layout.nodes[l.to],
      thickness = Math.max(0.7, l.value * layout.scale);
    svg
      .append("path")
      .attr({
        d: pmr.ribbon(x(a) + bar, a.from, x(b), b.to, thickness),
        fill: l.colour,
        opacity: 0.42
      })
      .append("title")
      .text(l.label + ": " + pmr.energy(l.value));
    if (thickness > 13 && b.node.column - a.node.column === 1 && a.node.column === 0)
      svg
        .append("text")
        .attr({ x: x(a) + bar + 10, y: a.from + thickness / 2 + 4, "class": "strong" })
        .text(
          l.label +
            (narrow ? "" : ", " + pmr.energy(l.value)) +
            " (" +
            Math.round((100 * l.value) / total) +
            " %)"
        );
    a.from += l.value * layout.scale;
    b.to += l.value * layout.scale;
  });
  var free = {};
  layout.used.forEach(function (n) {
    svg
      .append("rect")
      .attr({ x: x(n), y: n.y, width: bar, height: Math.max(1, n.height), fill: n.node.colour });
    var end = n.node.column === last,
      middle = n.y + n.height / 2;
    var y = end ? Math.max(middle - 2, free[n.node.column] || -100) : n.y - 20;
    free[n.node.column] = y + 31;
    var text = svg
      .append("text")
      .attr({
        x: end ? x(n) + bar + 8 : x(n),
        y: y,
        "text-anchor": !end && n.node.column > 0 ? "middle" : "start"
      });
    text.append("tspan").attr("class", "strong").text(n.node.label);
    text
      .append("tspan")
      .attr({ x: end ? x(n) + bar + 8 : x(n), dy: 14 })
      .text(
        pmr.energy(n.value) +
          (n.value < total ? " (" + d3.format(".2r")((100 * n.value) / total) + " %)" : "")
      );
  });
};

pmr.flow_rows = function (spec) {
  return [["from", "to", "path", "value [" + spec.unit + "]"]].concat(
    spec.links.map(function (l) {
      return [l.from, l.to, l.label, l.value];
    })
  );
};
