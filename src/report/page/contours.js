// A response over two parameters: its values as colours, lines of one level, runs as dots; or lines
// of several responses and regions of a density, one over the other.

pmr.viridis =
  "#440154 #472d7b #3b528b #2c728e #21918c #28ae80 #5ec962 #addc30 #fde725".split(" ");

pmr.contour_scale = function (axis, range) {
  var scale = axis.scale === "log" ? d3.scale.log() : d3.scale.linear();
  return scale.domain(axis.domain).range(range);
};

// Cells of a field on an even grid (by the logarithm on a logarithmic axis); the first variable
// changes slowest.
pmr.draw_field = function (svg, field, size) {
  var n = field.steps,
    low = d3.min(field.values),
    high = d3.max(field.values),
    width = size.width / (n - 1),
    height = size.height / (n - 1);
  field.values.forEach(function (value, k) {
    var i = Math.floor(k / n),
      j = k % n,
      share = high > low ? (value - low) / (high - low) : 0.5,
      left = Math.max(0, (i - 0.5) * width),
      right = Math.min(size.width, (i + 0.5) * width),
      top = Math.max(0, size.height - (j + 0.5) * height),
      bottom = Math.min(size.height, size.height - (j - 0.5) * height);
    svg.append("rect").attr({
      x: left,
      y: top,
      width: right - left + 0.3,
      height: bottom - top + 0.3,
      fill: pmr.viridis[Math.min(8, Math.floor(9 * share))],
      "fill-opacity": 0.45
    });
  });
};

pmr.draw_level = function (svg, line, x, y) {
  var path = "";
  for (var k = 0; k + 3 < line.segments.length; k += 4)
    path +=
      "M" +
      x(line.segments[k]).toFixed(1) +
      "," +
      y(line.segments[k + 1]).toFixed(1) +
      "L" +
      x(line.segments[k + 2]).toFixed(1) +
      "," +
      y(line.segments[k + 3]).toFixed(1);
  svg.append("path").attr({
    d: path || "M0,0",
    fill: "none",
    stroke: line.colour,
    "stroke-width": line.width || 1.2,
    "stroke-dasharray": line.dash || null
  });
};

pmr.draw_contours = function (holder, spec, width) {
  var named = spec.lines.filter((l) => l.label);
  if (named.length > 0) pmr.keys(holder, named);
  var size = { left: 58, right: 14, top: 24, bottom: 40 };
  size.width = width - size.left - size.right;
  size.height = Math.min(size.width, 320);
  var svg = holder
    .append("svg")
    .attr("viewBox", "0 0 " + width + " " + (size.height + size.top + size.bottom))
    .append("g")
    .attr("transform", "translate(" + size.left + "," + size.top + ")");
  var x = pmr.contour_scale(spec.x, [0, size.width]),
    y = pmr.contour_scale(spec.y, [size.height, 0]);
  if (spec.field) pmr.draw_field(svg, spec.field, size);
  pmr.scatter_axes(svg, x, y, size, spec);
  spec.lines.forEach(function (line) {
    pmr.draw_level(svg, line, x, y);
  });
  var runs = spec.points.filter((p) => !p.strong),
    marks = spec.points.filter((p) => p.strong);
  pmr.draw_scatter_series(svg, { points: runs, colour: "#1d2430" }, x, y);
  pmr.draw_scatter_series(svg, { points: marks, colour: "#d55e00" }, x, y);
};

pmr.contour_rows = function (spec) {
  var head = [pmr.axis_title(spec.x.label, spec.x.unit), pmr.axis_title(spec.y.label, spec.y.unit)];
  var rows = [["what"].concat(head)];
  spec.points.forEach(function (p) {
    rows.push([p.name || p.label || "run", p.x, p.y]);
  });
  spec.lines.forEach(function (line) {
    for (var k = 0; k + 1 < line.segments.length; k += 2)
      rows.push([line.label || "level", line.segments[k], line.segments[k + 1]]);
  });
  return rows;
};
