// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/netcdf/open.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <hdf5.h>
#include <netcdf.h>
#include <netcdf_mem.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"

namespace brash::netcdf {
namespace {

std::recursive_mutex& mutex() {
  static std::recursive_mutex one;
  return one;
}

constexpr const char* kWriteAgain = "copy or write the file again";

[[noreturn]] void refuse(const std::string& path, const std::string& what, const std::string& remedy = kWriteAgain) {
  throw InputError(Complaint{path, what, "a whole netCDF file with all its data inside", remedy});
}

[[noreturn]] void refuse_kind(const std::string& path) {
  refuse(path, "cannot be read: it does not begin as a netCDF file",
         "name a netCDF file, such as the run.nc of a run or the database that `brash failure database` wrote");
}

/// Larger files are not read: they would fill the memory of an ordinary machine.
constexpr std::size_t kMostMebibytes = 4096;

bool is_hdf5(std::string_view bytes) { return bytes.starts_with("\x89HDF\r\n\x1a\n"); }
bool is_classic(std::string_view bytes) {
  return bytes.size() >= 4 && bytes.starts_with("CDF") && (bytes[3] == 1 || bytes[3] == 2 || bytes[3] == 5);
}

/// Refuses a path that is not a regular file, and a file that does not begin as netCDF, before all of it is read.
std::string read(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0)
    refuse(path, "cannot be read: " + std::generic_category().message(errno), "check the path and its permissions");
  struct stat found {};
  std::array<char, 8> first{};
  const bool is_file = ::fstat(file, &found) == 0 && S_ISREG(found.st_mode);
  const ssize_t n = is_file ? ::pread(file, first.data(), first.size(), 0) : 0;
  ::close(file);
  if (!is_file)
    refuse(path, "cannot be read: it is a folder, a pipe or a device", "name a file, such as the run.nc of a run");
  const std::string_view begin(first.data(), static_cast<std::size_t>(n < 0 ? 0 : n));
  if (!is_hdf5(begin) && !is_classic(begin)) refuse_kind(path);
  return read_text_file(path, "a netCDF file", kMostMebibytes);
}

/// An open object of HDF5; closed in the end.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  hid_t id() const { return id_; }
  bool is_open() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Whether the values of a data set lie in the file itself.
bool is_inside(hid_t dataset) {
  const Handle list(H5Dget_create_plist(dataset), &H5Pclose);
  return list.is_open() && H5Pget_external_count(list.id()) == 0 && H5Pget_layout(list.id()) != H5D_VIRTUAL;
}

/// One link of a file. @return 0 to continue, 1 when it leads out of the file, or to data that do.
extern "C" herr_t look_at_link(hid_t group, const char* name, const H5L_info_t* link, void*) {
  if (link->type != H5L_TYPE_HARD) return 1;
  const Handle object(H5Oopen(group, name, H5P_DEFAULT), &H5Oclose);
  if (!object.is_open()) return 0;  // netCDF will report the fault
  return H5Iget_type(object.id()) == H5I_DATASET && !is_inside(object.id()) ? 1 : 0;
}

// HDF5 reads the image where it is: it neither copies nor frees it. H5LTopen_file_image could do so too, but leaks.
extern "C" {
void* image_itself(size_t, H5FD_file_image_op_t, void* bytes) { return bytes; }
void* image_copied(void* to, const void*, size_t, H5FD_file_image_op_t, void*) { return to; }
herr_t image_left(void*, H5FD_file_image_op_t, void*) { return 0; }
void* bytes_shared(void* bytes) { return bytes; }
herr_t bytes_left(void*) { return 0; }
}

/// Opens the HDF5 file `bytes`; < 0 when it is none. Each image open at a time has a name of its own.
hid_t open_image(std::string& bytes) {
  const Handle list(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
  constexpr std::size_t kIncrement = std::size_t{1} << 16;
  H5FD_file_image_callbacks_t callbacks{&image_itself, &image_copied, nullptr,     &image_left,
                                        &bytes_shared, &bytes_left,   bytes.data()};
  if (H5Pset_fapl_core(list.id(), kIncrement, /*backing_store=*/false) < 0 ||
      H5Pset_file_image_callbacks(list.id(), &callbacks) < 0 ||
      H5Pset_file_image(list.id(), bytes.data(), bytes.size()) < 0)
    return -1;
  const std::string name = fmt::format("image-{}", fmt::ptr(bytes.data()));
  return H5Fopen(name.c_str(), H5F_ACC_RDONLY, list.id());
}

/// @throws InputError when anything in the HDF5 file `bytes` lies outside of it. netCDF would follow it.
void refuse_references(const std::string& path, std::string& bytes) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Handle file(open_image(bytes), &H5Fclose);
  if (!file.is_open()) refuse(path, "cannot be read: it is not a whole HDF5 file");
  if (H5Lvisit(file.id(), H5_INDEX_NAME, H5_ITER_NATIVE, &look_at_link, nullptr) > 0)
    refuse(path, "refers to data in other files", "bring the data into the file with `nccopy`");
}

}  // namespace

Lock::Lock() : lock_(mutex()) {}

Source::Source(const std::string& path) : Source(path, read(path)) {}

Source::Source(const std::string& path, std::string bytes) : bytes_(std::move(bytes)) {
  if (is_hdf5(bytes_))
    refuse_references(path, bytes_);
  else if (!is_classic(bytes_))
    refuse_kind(path);
  const int status = nc_open_mem(kNameInMemory, NC_NOWRITE, bytes_.size(), bytes_.data(), &id_);
  if (status != NC_NOERR) refuse(path, fmt::format("cannot be read: {}", nc_strerror(status)));
}

Source::~Source() {
  if (id_ >= 0) nc_close(id_);
}

}  // namespace brash::netcdf
