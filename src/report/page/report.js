// Draws every chart of the page, again when its width or the time axis changes.

pmr.charts = [];

pmr.escape = function (text) {
  return String(text).replace(/[&<>"]/g, function (c) {
    return { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" }[c];
  });
};

pmr.kinds = {
  course: { draw: pmr.draw_line_chart, rows: pmr.line_rows },
  curves: { draw: pmr.draw_line_chart, rows: pmr.line_rows },
  azimuth: { draw: pmr.draw_azimuth, rows: pmr.azimuth_rows },
  layers: { draw: pmr.draw_layers, rows: pmr.layer_rows },
  unrolled: { draw: pmr.draw_unrolled, rows: pmr.unrolled_rows },
  scatter: { draw: pmr.draw_scatter, rows: pmr.scatter_rows },
  bars: { draw: pmr.draw_bars, rows: pmr.bar_rows },
  flow: { draw: pmr.draw_flow, rows: pmr.flow_rows },
  contours: { draw: pmr.draw_contours, rows: pmr.contour_rows }
};

pmr.csv = function (rows) {
  return (
    rows
      .map(function (row) {
        return row
          .map(function (cell) {
            var text = cell === null || cell === undefined ? "" : String(cell);
            return /[",\n]/.test(text) ? '"' + text.replace(/"/g, '""') + '"' : text;
          })
          .join(",");
      })
      .join("\n") + "\n"
  );
};

pmr.save = function (id, spec) {
  var url = URL.createObjectURL(
    new Blob([pmr.csv(pmr.kinds[spec.kind].rows(spec))], { type: "text/csv" })
  );
  var link = document.createElement("a");
  link.href = url;
  link.download = id + ".csv";
  document.body.appendChild(link);
  link.click();
  link.remove();
  URL.revokeObjectURL(url);
};

// Widths on A4: half a page where charts stand side by side, else a whole one.
pmr.paper_width = function (figure) {
  return figure.closest(".charts") ? 400 : 680;
};

pmr.draw = function (on_paper) {
  pmr.charts = [];
  d3.selectAll("figure.chart").each(function () {
    var figure = d3.select(this),
      id = this.getAttribute("data-chart"),
      spec = pmr.data.charts[id];
    var holder = figure.select(".plot").html(""),
      width = on_paper ? pmr.paper_width(this) : Math.max(280, holder.node().clientWidth);
    pmr.kinds[spec.kind].draw(holder, spec, width);
    if (figure.select(".csv").empty())
      figure
        .append("button")
        .attr({ "class": "csv", title: "save the data behind this plot" })
        .text("CSV")
        .on("click", function () {
          pmr.save(id, spec);
        });
  });
  d3.selectAll(".toggle button").classed("on", function () {
    return this.getAttribute("data-time") === pmr.time.scale;
  });
};

pmr.start = function () {
  var last = 0,
    waiting = null;
  d3.values(pmr.data.charts).forEach(function (spec) {
    if (spec.kind === "course") last = Math.max(last, d3.max(pmr.column(spec.lines[0].x)));
  });
  // Mixing takes a second, the reaction half an hour: only a log axis shows both.
  pmr.time.scale = last > 30 ? "log" : "linear";
  d3.selectAll(".toggle button").on("click", function () {
    pmr.time.scale = this.getAttribute("data-time");
    pmr.draw();
  });
  window.addEventListener("resize", function () {
    clearTimeout(waiting);
    waiting = setTimeout(function () {
      pmr.draw();
    }, 150);
  });
  window.addEventListener("beforeprint", function () {
    pmr.draw(true);
  });
  window.addEventListener("afterprint", function () {
    pmr.draw();
  });
  pmr.draw();
};

pmr.start();
