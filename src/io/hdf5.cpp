#include "io/hdf5.hpp"

#include <hdf5.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>

#include "io/hdf5_disk.hpp"
#include "pmr/base/errors.hpp"
#include "pmr/base/storage_error.hpp"

namespace pmr::io {
namespace {

static_assert(std::is_same_v<hid_t, std::int64_t>, "H5File keeps a hid_t as std::int64_t");

constexpr hsize_t chunk_rows = 16384;  // [1] of a dataset written once
constexpr hsize_t series_chunk = 512;  // [1] rows of an extendible one
constexpr unsigned deflate_level = 2;  // [1] 1 to 9; low, for speed (levels not compared)

// An identifier of HDF5 with its destructor.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  hid_t get() const { return id_; }
  bool is_valid() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

struct Reason {
  char text[200] = "";
};

// Keeps the innermost entry of HDF5's error stack; called from C, throws nothing.
herr_t keep_innermost(unsigned n, const H5E_error2_t* error, void* client) noexcept {
  auto* reason = static_cast<Reason*>(client);
  if (n == 0 && error->desc != nullptr)
    std::snprintf(reason->text, sizeof reason->text, "%s", error->desc);
  return 0;
}

std::string with_reason(const std::string& problem) {
  Reason reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  return reason.text[0] == '\0' ? problem : problem + " (HDF5: " + reason.text + ")";
}

// Of a file that is read: it is not what was wanted.
[[noreturn]] void fail(const std::filesystem::path& file, const std::string& problem) {
  throw CaseError({Fault{file.string(), "", with_reason(problem)}});
}

// Of a file that is written.
[[noreturn]] void fail_to_write(const std::filesystem::path& file, const std::string& problem) {
  throw StorageError(file.string() + ": " + with_reason(problem));
}

hid_t native(Number number) {
  switch (number) {
    case Number::float32:
      return H5T_NATIVE_FLOAT;
    case Number::float64:
      return H5T_NATIVE_DOUBLE;
    case Number::uint8:
      return H5T_NATIVE_UINT8;
    case Number::uint32:
      return H5T_NATIVE_UINT32;
    case Number::uint64:
      return H5T_NATIVE_UINT64;
  }
  return -1;
}

// Version 1.8 files carry checksums of their metadata and open in every reader in use. No locks:
// a file under write is a temporary that nobody else knows.
Handle file_access() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // failures are reported by exceptions alone
  Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(list.get(), H5F_LIBVER_V18, H5F_LIBVER_V18);
  H5Pset_file_locking(list.get(), false, true);
  H5Pset_fclose_degree(list.get(), H5F_CLOSE_STRONG);
  return list;
}

// Likewise for a file that is written: what the disk refuses is kept in `refusal` (hdf5_disk.hpp).
Handle write_access(int* refusal) {
  Handle list = file_access();
  write_through(list.get(), refusal);
  return list;
}

// Without time stamps equal runs give equal files.
Handle untimed(hid_t kind) {
  Handle list(H5Pcreate(kind), H5Pclose);
  H5Pset_obj_track_times(list.get(), false);
  return list;
}

Handle dataset_creation(Shape shape, Packing packing) {
  Handle list = untimed(H5P_DATASET_CREATE);
  if (shape.rows == 0 && packing != Packing::extendible) return list;
  const hsize_t rows =
      packing == Packing::extendible ? series_chunk : std::min<hsize_t>(chunk_rows, shape.rows);
  const std::array<hsize_t, 2> chunk{rows, shape.width};
  H5Pset_chunk(list.get(), shape.width == 1 ? 1 : 2, chunk.data());
  if (packing != Packing::checked) {
    H5Pset_shuffle(list.get());
    H5Pset_deflate(list.get(), deflate_level);
  }
  H5Pset_fletcher32(list.get());
  return list;
}

Handle dataspace(Shape shape, Packing packing) {
  const std::array<hsize_t, 2> size{shape.rows, shape.width};
  const std::array<hsize_t, 2> largest{H5S_UNLIMITED, shape.width};
  return {H5Screate_simple(shape.width == 1 ? 1 : 2, size.data(),
                           packing == Packing::extendible ? largest.data() : nullptr),
          H5Sclose};
}

Handle text_type(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), std::max<std::size_t>(bytes, 1));
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  return type;
}

std::string without_padding(const char* data, std::size_t size) {
  while (size > 0 && data[size - 1] == '\0') --size;
  return {data, size};
}

bool is_fixed_text(hid_t type) {
  return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
}

Handle open_dataset(hid_t file, const std::filesystem::path& path, const std::string& name) {
  Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set.is_valid()) fail(path, "dataset " + name + " wanted, not found or damaged");
  return set;
}

Handle open_attribute(hid_t file, const std::filesystem::path& path, const std::string& object,
                      const std::string& name) {
  Handle attribute(H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose);
  if (!attribute.is_valid())
    fail(path, "attribute " + name + " of " + object + " wanted, not found");
  return attribute;
}

}  // namespace

H5File H5File::create(const std::filesystem::path& path) {
  auto refusal = std::make_unique<int>(0);
  const Handle access = write_access(refusal.get());
  const Handle creation = untimed(H5P_FILE_CREATE);
  const hid_t id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get());
  if (id < 0) fail_to_write(path, "cannot be created");
  return {path, id, std::move(refusal)};
}

H5File H5File::open(const std::filesystem::path& path) {
  const Handle access = file_access();
  if (!std::filesystem::exists(path)) fail(path, "no such file");
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get());
  if (id < 0) fail(path, "an HDF5 file of pmr wanted; this one is foreign or damaged");
  return {path, id, nullptr};
}

H5File H5File::modify(const std::filesystem::path& path) {
  auto refusal = std::make_unique<int>(0);
  const Handle access = write_access(refusal.get());
  const hid_t id = H5Fopen(path.c_str(), H5F_ACC_RDWR, access.get());
  if (id < 0) fail(path, "an HDF5 file of pmr wanted; this one is foreign or damaged");
  return {path, id, std::move(refusal)};
}

H5File::H5File(H5File&& other) noexcept
    : path_(std::move(other.path_)),
      id_(std::exchange(other.id_, -1)),
      refusal_(std::move(other.refusal_)) {}

H5File::~H5File() {
  if (id_ >= 0) H5Fclose(id_);
}

void H5File::close() {
  const hid_t id = std::exchange(id_, -1);
  const bool flushed = H5Fflush(id, H5F_SCOPE_GLOBAL) >= 0;
  const bool closed = H5Fclose(id) >= 0;
  if (refusal_ && *refusal_ != 0)
    throw StorageError(path_.string() + ": cannot be written: " + std::strerror(*refusal_));
  if (!closed || !flushed) fail_to_write(path_, "cannot be written to its end");
}

void H5File::make_group(const std::string& path) {
  for (std::size_t slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {
    const std::string part = path.substr(0, slash);
    if (!has(part)) {
      const Handle creation = untimed(H5P_GROUP_CREATE);
      const Handle group(H5Gcreate2(id_, part.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT),
                         H5Gclose);
      if (!group.is_valid()) fail_to_write(path_, "group " + part + " cannot be made");
    }
    if (slash == std::string::npos) return;
  }
}

void H5File::remove(const std::string& path) {
  if (H5Ldelete(id_, path.c_str(), H5P_DEFAULT) < 0)
    fail_to_write(path_, path + " cannot be removed");
}

bool H5File::has(const std::string& path) const {
  if (path == "/") return true;
  for (std::size_t slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {
    if (H5Lexists(id_, path.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
    if (slash == std::string::npos) return true;
  }
}

bool H5File::is_group(const std::string& path) const {
  const Handle object(H5Oopen(id_, path.c_str(), H5P_DEFAULT), H5Oclose);
  return object.is_valid() && H5Iget_type(object.get()) == H5I_GROUP;
}

std::vector<std::string> H5File::children(const std::string& group) const {
  const Handle handle(H5Gopen2(id_, group.c_str(), H5P_DEFAULT), H5Gclose);
  H5G_info_t info;
  if (!handle.is_valid() || H5Gget_info(handle.get(), &info) < 0)
    fail(path_, "group " + group + " wanted, not found or damaged");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    std::array<char, 256> name{};
    if (H5Lget_name_by_idx(handle.get(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(),
                           name.size(), H5P_DEFAULT) < 0)
      fail(path_, "group " + group + " is damaged");
    names.emplace_back(name.data());
  }
  return names;
}

Shape H5File::shape(const std::string& dataset) const {
  const Handle set = open_dataset(id_, path_, dataset);
  const Handle space(H5Dget_space(set.get()), H5Sclose);
  std::array<hsize_t, 2> size{0, 1};
  const int rank = H5Sget_simple_extent_ndims(space.get());
  if (rank < 1 || rank > 2) fail(path_, "dataset " + dataset + " wanted with 1 or 2 dimensions");
  H5Sget_simple_extent_dims(space.get(), size.data(), nullptr);
  return {size[0], size[1]};
}

std::size_t H5File::rows_of(const std::string& path, std::size_t width) const {
  const Shape found = shape(path);
  if (found.width != width)
    fail(path_, "dataset " + path + " wanted with rows of " + std::to_string(width) +
                    ", found rows of " + std::to_string(found.width));
  return found.rows;
}

void H5File::write_block(const std::string& path, const Block& block, const Storage& storage) {
  const std::size_t slash = path.rfind('/');
  if (slash > 0) make_group(path.substr(0, slash));
  const Handle creation = dataset_creation(block.shape, storage.packing);
  const Handle space = dataspace(block.shape, storage.packing);
  {
    const Handle set(H5Dcreate2(id_, path.c_str(), native(storage.number), space.get(), H5P_DEFAULT,
                                creation.get(), H5P_DEFAULT),
                     H5Dclose);
    const hid_t memory = native(block.number);
    if (!set.is_valid() || (block.shape.rows > 0 && H5Dwrite(set.get(), memory, H5S_ALL, H5S_ALL,
                                                             H5P_DEFAULT, block.data) < 0))
      fail_to_write(path_, "dataset " + path + " cannot be written");
  }
  set_attribute(path, "unit", storage.unit);
}

void H5File::read_block(const std::string& path, Number number, void* data) const {
  const Handle set = open_dataset(id_, path_, path);
  const Handle type(H5Dget_type(set.get()), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type.get());
  if (kind != H5T_FLOAT && kind != H5T_INTEGER)
    fail(path_, "dataset " + path + " holds no numbers");
  if (shape(path).rows > 0 &&
      H5Dread(set.get(), native(number), H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
    fail(path_, "dataset " + path + " is damaged");
}

void H5File::extend(const std::string& path, std::span<const double> values) {
  const hsize_t first = rows_of(path, 1);
  const hsize_t count = values.size();
  if (count == 0) return;
  const hsize_t total = first + count;
  const Handle set = open_dataset(id_, path_, path);
  const bool grown = H5Dset_extent(set.get(), &total) >= 0;
  const Handle target(H5Dget_space(set.get()), H5Sclose);
  const Handle source(H5Screate_simple(1, &count, nullptr), H5Sclose);
  H5Sselect_hyperslab(target.get(), H5S_SELECT_SET, &first, nullptr, &count, nullptr);
  if (!grown || H5Dwrite(set.get(), H5T_NATIVE_DOUBLE, source.get(), target.get(), H5P_DEFAULT,
                         values.data()) < 0)
    fail_to_write(path_, "dataset " + path + " cannot be extended");
}

void H5File::shorten(const std::string& path, std::size_t rows) {
  const hsize_t size = rows;
  const Handle set = open_dataset(id_, path_, path);
  if (H5Dset_extent(set.get(), &size) < 0)
    fail_to_write(path_, "dataset " + path + " cannot be shortened");
}

void H5File::write_texts(const std::string& path, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::vector<char> buffer(texts.size() * longest, '\0');
  for (std::size_t i = 0; i < texts.size(); ++i)
    std::copy(texts[i].begin(), texts[i].end(),
              buffer.begin() + static_cast<std::ptrdiff_t>(i * longest));
  const Handle type = text_type(longest);
  const Handle space = dataspace({texts.size(), 1}, Packing::checked);
  {
    const Handle creation = untimed(H5P_DATASET_CREATE);
    const Handle set(H5Dcreate2(id_, path.c_str(), type.get(), space.get(), H5P_DEFAULT,
                                creation.get(), H5P_DEFAULT),
                     H5Dclose);
    if (!set.is_valid() || (!texts.empty() && H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL,
                                                       H5P_DEFAULT, buffer.data()) < 0))
      fail_to_write(path_, "text " + path + " cannot be written");
  }
  set_attribute(path, "unit", "1");
}

std::vector<std::string> H5File::read_texts(const std::string& path) const {
  const std::size_t rows = rows_of(path, 1);
  const Handle set = open_dataset(id_, path_, path);
  const Handle type(H5Dget_type(set.get()), H5Tclose);
  if (!is_fixed_text(type.get())) fail(path_, "dataset " + path + " wanted as text");
  const std::size_t size = H5Tget_size(type.get());
  std::vector<char> buffer(rows * size, '\0');
  if (rows > 0 && H5Dread(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer.data()) < 0)
    fail(path_, "text " + path + " is damaged");
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < rows; ++i)
    texts.push_back(without_padding(buffer.data() + i * size, size));
  return texts;
}

void H5File::set_attribute(const std::string& path, const std::string& name,
                           std::string_view text) {
  if (has_attribute(path, name)) H5Adelete_by_name(id_, path.c_str(), name.c_str(), H5P_DEFAULT);
  const std::string padded = text.empty() ? std::string(1, '\0') : std::string(text);
  const Handle type = text_type(text.size());
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate_by_name(id_, path.c_str(), name.c_str(), type.get(), space.get(),
                                           H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  if (!attribute.is_valid() || H5Awrite(attribute.get(), type.get(), padded.data()) < 0)
    fail_to_write(path_, "attribute " + name + " of " + path + " cannot be written");
}

void H5File::set_attribute(const std::string& path, const std::string& name, double value) {
  if (has_attribute(path, name)) H5Adelete_by_name(id_, path.c_str(), name.c_str(), H5P_DEFAULT);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate_by_name(id_, path.c_str(), name.c_str(), H5T_NATIVE_DOUBLE,
                                           space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  if (!attribute.is_valid() || H5Awrite(attribute.get(), H5T_NATIVE_DOUBLE, &value) < 0)
    fail_to_write(path_, "attribute " + name + " of " + path + " cannot be written");
}

bool H5File::has_attribute(const std::string& path, const std::string& name) const {
  return H5Aexists_by_name(id_, path.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::string H5File::text_attribute(const std::string& path, const std::string& name) const {
  const Handle attribute = open_attribute(id_, path_, path, name);
  const Handle type(H5Aget_type(attribute.get()), H5Tclose);
  if (!is_fixed_text(type.get())) fail(path_, "attribute " + name + " of " + path + " is no text");
  std::string text(H5Tget_size(type.get()), '\0');
  if (H5Aread(attribute.get(), type.get(), text.data()) < 0)
    fail(path_, "attribute " + name + " of " + path + " is damaged");
  return without_padding(text.data(), text.size());
}

double H5File::number_attribute(const std::string& path, const std::string& name) const {
  const Handle attribute = open_attribute(id_, path_, path, name);
  double value = 0.0;
  if (H5Aread(attribute.get(), H5T_NATIVE_DOUBLE, &value) < 0)
    fail(path_, "attribute " + name + " of " + path + " is no number");
  return value;
}

std::vector<std::string> H5File::attributes(const std::string& path) const {
  H5O_info_t info;
  if (H5Oget_info_by_name(id_, path.c_str(), &info, H5P_DEFAULT) < 0)
    fail(path_, path + " wanted, not found or damaged");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.num_attrs; ++i) {
    std::array<char, 256> name{};
    if (H5Aget_name_by_idx(id_, path.c_str(), H5_INDEX_NAME, H5_ITER_INC, i, name.data(),
                           name.size(), H5P_DEFAULT) < 0)
      fail(path_, "attributes of " + path + " are damaged");
    names.emplace_back(name.data());
  }
  return names;
}

void set_format(H5File& file, std::string_view format, int version) {
  file.set_attribute("/", "format", format);
  file.set_attribute("/", "format_version", static_cast<double>(version));
}

void require_format(const H5File& file, std::string_view format, int version) {
  const std::string wanted =
      std::string(format) + " version " + std::to_string(version) + " wanted, found ";
  const auto refuse = [&](const std::string& found) {
    throw CaseError({Fault{file.path().string(), "", wanted + found}});
  };
  if (!file.has_attribute("/", "format") || !file.has_attribute("/", "format_version"))
    refuse("an HDF5 file without format");
  const std::string found = file.text_attribute("/", "format");
  const int found_version = static_cast<int>(file.number_attribute("/", "format_version"));
  if (found != format || found_version != version)
    refuse(found + " version " + std::to_string(found_version));
}

}  // namespace pmr::io
