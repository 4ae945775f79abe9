#include "io/xdmf.hpp"

#include <charconv>

#include "io/snapshot.hpp"

namespace pmr::io {
namespace {

// What is offered for colouring; the position is the geometry.
constexpr std::array<const char*, 7> shown{"radius",   "temperature", "delta", "species",
                                           "velocity", "mass",        "id"};

std::string number_type(Number number) {
  switch (number) {
    case Number::float32:
      return R"(NumberType="Float" Precision="4")";
    case Number::float64:
      return R"(NumberType="Float" Precision="8")";
    case Number::uint8:
      return R"(NumberType="UChar" Precision="1")";
    case Number::uint32:
      return R"(NumberType="UInt" Precision="4")";
    case Number::uint64:
      return R"(NumberType="UInt" Precision="8")";
  }
  return {};
}

std::string data_item(const H5File& run, const std::string& group, const std::string& field) {
  const std::string path = group + "/" + field;
  const Shape shape = run.shape(path);
  std::string size = std::to_string(shape.rows);
  if (shape.width > 1) size += " " + std::to_string(shape.width);
  return "<DataItem Dimensions=\"" + size + "\" " + number_type(*snapshot_number(field)) +
         " Format=\"HDF\">run.h5:" + path + "</DataItem>\n";
}

std::string attribute(const H5File& run, const std::string& group, const std::string& field) {
  const char* kind = run.shape(group + "/" + field).width == 3 ? "Vector" : "Scalar";
  return "<Attribute Name=\"" + field + "\" AttributeType=\"" + kind + "\" Center=\"Node\">" +
         data_item(run, group, field) + "</Attribute>\n";
}

std::string time_text(double time) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), time).ptr;
  return {digits.data(), end};
}

std::string points(const std::string& cells) {
  return "<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"" + cells +
         "\" NodesPerElement=\"1\"><DataItem Dimensions=\"" + cells + "\" " +
         number_type(Number::uint32) +
         " Format=\"HDF\">run.h5:" + vertices_path(std::stoul(cells)) + "</DataItem></Topology>\n";
}

// Grains that adhere to walls; their radii stand in the header.
std::string adhered_grid(const H5File& run, const std::string& group) {
  const std::string cells = std::to_string(run.shape(group + "/adhered").rows);
  const auto item = [&](const std::string& size, Number number, const std::string& path) {
    return "<DataItem Dimensions=\"" + size + "\" " + number_type(number) +
           " Format=\"HDF\">run.h5:" + path + "</DataItem>";
  };
  std::string text = "<Grid Name=\"adhered\" GridType=\"Uniform\">\n" + points(cells) +
                     "<Geometry GeometryType=\"XYZ\">" +
                     item(cells + " 3", Number::float32, group + "/adhered") + "</Geometry>\n";
  if (run.has("/adhered_radius"))
    text += "<Attribute Name=\"radius\" AttributeType=\"Scalar\" Center=\"Node\">" +
            item(cells, Number::float64, "/adhered_radius") + "</Attribute>\n";
  return text + "</Grid>\n";
}

std::string grid(const H5File& run, const std::string& group) {
  const std::size_t count = run.shape(group + "/id").rows;
  if (count == 0) return {};
  std::string text = "<Grid Name=\"particles\" GridType=\"Uniform\">\n<Time Value=\"" +
                     time_text(run.number_attribute(group, "time")) + "\"/>\n";
  const std::string cells = std::to_string(count);
  text += points(cells);
  text += "<Geometry GeometryType=\"XYZ\">" + data_item(run, group, "position") + "</Geometry>\n";
  for (const char* field : shown) text += attribute(run, group, field);
  text += "</Grid>\n";
  if (!run.has(group + "/adhered")) return text;
  return "<Grid Name=\"spheres\" GridType=\"Collection\" CollectionType=\"Spatial\">\n<Time "
         "Value=\"" +
         time_text(run.number_attribute(group, "time")) + "\"/>\n" + text +
         adhered_grid(run, group) + "</Grid>\n";
}

}  // namespace

std::string xdmf_text(const H5File& run) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n<Domain>\n"
      "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  for (const std::string& group : snapshot_groups(run)) text += grid(run, group);
  return text + "</Grid>\n</Domain>\n</Xdmf>\n";
}

}  // namespace pmr::io
