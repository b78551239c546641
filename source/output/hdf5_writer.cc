// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/hdf5.h>
#include <ringmotor/output/hdf5_types.h>
#include <ringmotor/parameters/errors.h>

#include <deal.II/base/exceptions.h>

#include <functional>
#include <hdf5_hl.h>
#include <numeric>

using namespace dealii;

namespace ringmotor
{
  namespace
  {
    /** Passes on what an HDF5 call returned. */
    template <typename Result>
    Result must(const Result result, const std::string &action)
    {
      if (result < 0)
        throw ComputationError("HDF5 failed to " + action);
      return result;
    }

    hid_t create_in_memory()
    {
      // HDF5 prints its failures on the terminal; must() reports them in one line.
      H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);

      // HDF5 takes two open files of one name for the same file.
      static unsigned int n_files = 0;
      const std::string name      = "in memory " + std::to_string(n_files++);

      const std::string action    = "set up a file in memory";
      const std::size_t increment = 1 << 20;
      const bool is_kept_on_disk  = false;
      const Hdf5Handle access(must(H5Pcreate(H5P_FILE_ACCESS), action));
      must(H5Pset_fapl_core(access, increment, is_kept_on_disk), action);
      const hid_t file = must(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), action);
      // Objects get the format with checksums, as HDF5 can crash on damaged ones without them. The
      // head of the file keeps the older format: H5Fget_file_image() spoils the checksum of the
      // newer one (HDF5 issue 1915).
      must(H5Fset_libver_bounds(file, H5F_LIBVER_V110, H5F_LIBVER_V110), action);
      return file;
    }

    /** Link properties: creates the groups on the way. */
    hid_t create_groups_on_the_way(const std::string &action)
    {
      const hid_t links = must(H5Pcreate(H5P_LINK_CREATE), action);
      must(H5Pset_create_intermediate_group(links, 1), action);
      return links;
    }

    /** Adds a scalar attribute to an open object. */
    template <typename Number>
    void add_attribute(const hid_t object, const std::string &name, const Number &value)
    {
      const std::string action = "write the attribute '" + name + "'";

      const std::vector<Number> values = {value};
      const auto &buffer               = Hdf5Type<Number>::to_buffer(values);
      const Hdf5Handle type(must(Hdf5Type<Number>::type_for(values), action));
      const Hdf5Handle space(must(H5Screate(H5S_SCALAR), action));
      const Hdf5Handle attribute(
          must(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), action));
      must(H5Awrite(attribute, type, buffer.data()), action);
    }
  } // namespace

  Hdf5Writer::Hdf5Writer(const std::string &format, const unsigned int format_version)
      : file(create_in_memory())
  {
    set_attribute("/", "format", format);
    set_attribute("/", "format_version", format_version);
  }

  template <typename Number>
  void Hdf5Writer::write(const std::string &name, const std::vector<Number> &values,
                         const std::vector<std::size_t> &dims, const std::string &unit,
                         const std::string &description)
  {
    AssertDimension(values.size(), std::accumulate(dims.begin(), dims.end(), std::size_t(1),
                                                   std::multiplies<std::size_t>()));
    const std::string action = "write the dataset '" + name + "'";

    const auto &buffer = Hdf5Type<Number>::to_buffer(values);
    const std::vector<hsize_t> sizes(dims.begin(), dims.end());
    const Hdf5Handle links(create_groups_on_the_way(action));
    const Hdf5Handle type(must(Hdf5Type<Number>::type_for(values), action));
    const Hdf5Handle space(must(H5Screate_simple(sizes.size(), sizes.data(), nullptr), action));
    const Hdf5Handle layout(must(H5Pcreate(H5P_DATASET_CREATE), action));
    must(H5Pset_obj_track_times(layout, false), action); // the same values make the same file
    if (!values.empty() && !dims.empty())
    {
      // One chunk with a checksum, by which HDF5 detects damaged values.
      must(H5Pset_chunk(layout, sizes.size(), sizes.data()), action);
      must(H5Pset_fletcher32(layout), action);
    }
    const Hdf5Handle dataset(
        must(H5Dcreate2(file, name.c_str(), type, space, links, layout, H5P_DEFAULT), action));
    must(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer.data()), action);

    add_attribute(dataset, "unit", unit);
    add_attribute(dataset, "description", description);
  }

  template <typename Number>
  void Hdf5Writer::set_attribute(const std::string &object, const std::string &name,
                                 const Number &value)
  {
    const std::string action = "open '" + object + "'";

    const Hdf5Handle links(create_groups_on_the_way(action));
    const Hdf5Handle target(
        must(H5LTpath_valid(file, object.c_str(), true) > 0
                 ? H5Oopen(file, object.c_str(), H5P_DEFAULT)
                 : H5Gcreate2(file, object.c_str(), links, H5P_DEFAULT, H5P_DEFAULT),
             action));
    add_attribute(target, name, value);
  }

  void Hdf5Writer::save(const std::string &path) const
  {
    const std::string action = "finish '" + path + "'";

    must(H5Fflush(file, H5F_SCOPE_GLOBAL), action);
    std::string image(must(H5Fget_file_image(file, nullptr, 0), action), '\0');
    must(H5Fget_file_image(file, image.data(), image.size()), action);
    write_file(path, image);
  }

#define INSTANTIATE(Number)                                                                        \
  template void Hdf5Writer::write(const std::string &, const std::vector<Number> &,                \
                                  const std::vector<std::size_t> &, const std::string &,           \
                                  const std::string &);                                            \
  template void Hdf5Writer::set_attribute(const std::string &, const std::string &, const Number &)

  INSTANTIATE(double);
  INSTANTIATE(int);
  INSTANTIATE(unsigned int);
  INSTANTIATE(std::string);
#undef INSTANTIATE
} // namespace ringmotor
