#include "io/hdf5_disk.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <memory>
#include <new>

namespace pmr::io {
namespace {

constexpr haddr_t largest_address = std::numeric_limits<off_t>::max();

struct Access {
  int* refusal;
};

// `common` comes first: HDF5 knows the file by it.
struct DiskFile {
  H5FD_t common;
  int descriptor;
  haddr_t allocated;  // [B] end of what HDF5 has given out
  haddr_t end;        // [B] of the file as HDF5 is to see it
  dev_t device;
  ino_t inode;
  int* refusal;

  void refuse() const {
    if (*refusal == 0) *refusal = errno;
  }
};

DiskFile* disk(H5FD_t* file) { return reinterpret_cast<DiskFile*>(file); }
const DiskFile* disk(const H5FD_t* file) { return reinterpret_cast<const DiskFile*>(file); }

H5FD_t* open_file(const char* name, unsigned flags, hid_t access, haddr_t) noexcept {
  const int how = (flags & H5F_ACC_RDWR ? O_RDWR : O_RDONLY) |
                  (flags & H5F_ACC_CREAT ? O_CREAT : 0) | (flags & H5F_ACC_TRUNC ? O_TRUNC : 0);
  const auto* wish = static_cast<const Access*>(H5Pget_driver_info(access));
  struct stat status {};
  const int descriptor = ::open(name, how | O_CLOEXEC, 0666);
  if (descriptor < 0) return nullptr;  // HDF5 also tries whether there is a file
  if (::fstat(descriptor, &status) != 0) {
    ::close(descriptor);
    return nullptr;
  }
  auto* file = new (std::nothrow) DiskFile{{},
                                           descriptor,
                                           0,
                                           static_cast<haddr_t>(status.st_size),
                                           status.st_dev,
                                           status.st_ino,
                                           wish->refusal};
  return reinterpret_cast<H5FD_t*>(file);
}

herr_t close_file(H5FD_t* file) noexcept {
  const std::unique_ptr<DiskFile> owner(disk(file));
  if (::close(owner->descriptor) != 0) owner->refuse();
  return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) noexcept {
  const DiskFile &p = *disk(a), &q = *disk(b);
  if (p.device != q.device) return p.device < q.device ? -1 : 1;
  if (p.inode != q.inode) return p.inode < q.inode ? -1 : 1;
  return 0;
}

herr_t features(const H5FD_t*, unsigned long* flags) noexcept {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t allocated(const H5FD_t* file, H5FD_mem_t) noexcept { return disk(file)->allocated; }

herr_t allocate(H5FD_t* file, H5FD_mem_t, haddr_t address) noexcept {
  disk(file)->allocated = address;
  return 0;
}

haddr_t end_of(const H5FD_t* file, H5FD_mem_t) noexcept { return disk(file)->end; }

// What lies behind the end, or was refused by the disk, reads as zeros.
herr_t read(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t size, void* buffer) noexcept {
  auto* to = static_cast<char*>(buffer);
  while (size > 0) {
    const ssize_t count = ::pread(disk(file)->descriptor, to, size, static_cast<off_t>(address));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return -1;
    if (count == 0) break;
    to += count;
    size -= static_cast<size_t>(count);
    address += static_cast<haddr_t>(count);
  }
  std::memset(to, 0, size);
  return 0;
}

herr_t write(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t size,
             const void* buffer) noexcept {
  DiskFile& f = *disk(file);
  f.end = std::max(f.end, address + size);
  const auto* from = static_cast<const char*>(buffer);
  while (size > 0 && *f.refusal == 0) {
    const ssize_t count = ::pwrite(f.descriptor, from, size, static_cast<off_t>(address));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      f.refuse();
      break;
    }
    from += count;
    size -= static_cast<size_t>(count);
    address += static_cast<haddr_t>(count);
  }
  return 0;
}

herr_t truncate(H5FD_t* file, hid_t, hbool_t) noexcept {
  DiskFile& f = *disk(file);
  if (f.end == f.allocated) return 0;
  if (*f.refusal == 0 && ::ftruncate(f.descriptor, static_cast<off_t>(f.allocated)) != 0)
    f.refuse();
  f.end = f.allocated;
  return 0;
}

H5FD_class_t driver() {
  H5FD_class_t d{};
  d.name = "pmr_disk";
  d.maxaddr = largest_address;
  d.fc_degree = H5F_CLOSE_WEAK;
  d.fapl_size = sizeof(Access);
  d.open = open_file;
  d.close = close_file;
  d.cmp = compare;
  d.query = features;
  d.get_eoa = allocated;
  d.set_eoa = allocate;
  d.get_eof = end_of;
  d.read = read;
  d.write = write;
  d.truncate = truncate;
  constexpr H5FD_mem_t kinds[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(kinds), std::end(kinds), std::begin(d.fl_map));
  return d;
}

}  // namespace

herr_t write_through(hid_t access, int* refusal) {
  static const H5FD_class_t description = driver();
  static const hid_t id = H5FDregister(&description);
  const Access wish{refusal};
  return H5Pset_driver(access, id, &wish);
}

}  // namespace pmr::io
