// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/hdf5.h>
#include <ringmotor/output/hdf5_types.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <filesystem>
#include <hdf5_hl.h>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    [[noreturn]] void reject(const std::string &path, const std::string &owner,
                             const std::string &found, const std::string &expected)
    {
      throw UserError("'" + path + "'" + (owner.empty() ? "" : ", " + owner) + ": found " + found +
                      ", expected " + expected +
                      "; write the file again with the program it comes from");
    }

    std::string quoted(const std::string &text)
    {
      return "'" + text + "'";
    }

    std::string dataset_called(const std::string &name)
    {
      return "dataset " + quoted(name);
    }

    std::string to_text(const H5T_class_t type)
    {
      switch (type)
      {
      case H5T_INTEGER:
        return "integers";
      case H5T_FLOAT:
        return "floating point numbers";
      case H5T_STRING:
        return "texts";
      default:
        return "values of another type";
      }
    }

    std::string to_text(const std::vector<std::size_t> &dims)
    {
      std::ostringstream text;
      text << "the size (";
      for (std::size_t d = 0; d < dims.size(); ++d)
      {
        text << (d == 0 ? "" : " x ");
        if (dims[d] == Hdf5Reader::any_size)
          text << "any";
        else
          text << dims[d];
      }
      text << ")";
      return text.str();
    }

    hid_t open_file(const std::string &path)
    {
      // HDF5 prints its failures on the terminal; reject() reports them in one line.
      H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);

      const std::string expected = "a readable HDF5 file";
      std::error_code error;
      if (!std::filesystem::exists(path, error))
        reject(path, "", "nothing", expected);
      const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
      if (file < 0)
        reject(path, "", "a damaged or locked file, or another format", expected);
      return file;
    }

    hid_t open_dataset(const hid_t file, const std::string &path, const std::string &name)
    {
      const bool exists   = H5LTpath_valid(file, name.c_str(), true) > 0;
      const hid_t dataset = exists ? H5Dopen2(file, name.c_str(), H5P_DEFAULT) : H5I_INVALID_HID;
      if (dataset < 0)
        reject(path, dataset_called(name), "nothing", "values");
      return dataset;
    }

    std::vector<std::size_t> sizes_of(const hid_t dataset)
    {
      const Hdf5Handle space(H5Dget_space(dataset));
      std::vector<hsize_t> sizes(std::max(0, H5Sget_simple_extent_ndims(space)));
      H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
      return {sizes.begin(), sizes.end()};
    }

    bool agree(const std::vector<std::size_t> &found, const std::vector<std::size_t> &expected)
    {
      return std::equal(found.begin(), found.end(), expected.begin(), expected.end(),
                        [](const std::size_t size, const std::size_t wanted)
                        { return wanted == size || wanted == Hdf5Reader::any_size; });
    }
  } // namespace

  Hdf5Reader::Hdf5Reader(const std::string &path, const std::string &format,
                         const unsigned int format_version)
      : path(path), file(open_file(path))
  {
    const auto found_format = attribute<std::string>("/", "format");
    if (found_format != format)
      reject(path, "", "the format " + quoted(found_format), quoted(format));
    const auto found_version = attribute<unsigned int>("/", "format_version");
    if (found_version != format_version)
      reject(path, "", "version " + std::to_string(found_version) + " of its format",
             "version " + std::to_string(format_version));
  }

  std::vector<std::size_t> Hdf5Reader::dims(const std::string &name) const
  {
    return sizes_of(Hdf5Handle(open_dataset(file, path, name)));
  }

  template <typename Number>
  std::vector<Number> Hdf5Reader::read(const std::string &name,
                                       const std::vector<std::size_t> &dims,
                                       const std::string &unit) const
  {
    using Type = Hdf5Type<Number>;
    const Hdf5Handle dataset(open_dataset(file, path, name));

    const Hdf5Handle stored_type(H5Dget_type(dataset));
    const H5T_class_t stored = H5Tget_class(stored_type);
    if (!Type::accepts(stored))
      reject(path, dataset_called(name), to_text(stored), Type::name);
    const std::vector<std::size_t> found_dims = sizes_of(dataset);
    if (!agree(found_dims, dims))
      reject(path, dataset_called(name), to_text(found_dims), to_text(dims));
    const auto found_unit = attribute<std::string>(name, "unit");
    if (found_unit != unit)
      reject(path, dataset_called(name), "the unit " + quoted(found_unit), quoted(unit));

    std::size_t n_values = 1;
    for (const std::size_t size : found_dims)
      n_values *= size;
    const Hdf5Handle type(Type::type_from(stored_type));
    auto buffer = Type::room_for(n_values, type);
    if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer.data()) < 0)
      reject(path, dataset_called(name), "values that cannot be read", "an undamaged file");
    return Type::from_buffer(buffer, n_values);
  }

  bool Hdf5Reader::has(const std::string &name) const
  {
    return H5Lexists(file, name.c_str(), H5P_DEFAULT) > 0;
  }

  template <typename Number>
  Number Hdf5Reader::attribute(const std::string &object, const std::string &name) const
  {
    using Type              = Hdf5Type<Number>;
    const std::string owner = "attribute " + quoted(name) + " of " + quoted(object);

    const bool exists = H5Aexists_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
    const Hdf5Handle attribute(
        exists ? H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT)
               : H5I_INVALID_HID);
    if (!attribute.is_valid())
      reject(path, owner, "nothing", "a value");

    const Hdf5Handle stored_type(H5Aget_type(attribute));
    const H5T_class_t stored = H5Tget_class(stored_type);
    const Hdf5Handle space(H5Aget_space(attribute));
    if (!Type::accepts(stored) || H5Sget_simple_extent_npoints(space) != 1)
      reject(path, owner, to_text(stored), std::string("one value from ") + Type::name);

    const Hdf5Handle type(Type::type_from(stored_type));
    auto buffer = Type::room_for(1, type);
    if (H5Aread(attribute, type, buffer.data()) < 0)
      reject(path, owner, "a value that cannot be read", "an undamaged file");
    return Type::from_buffer(buffer, 1).front();
  }

#define INSTANTIATE(Number)                                                                        \
  template std::vector<Number> Hdf5Reader::read(                                                   \
      const std::string &, const std::vector<std::size_t> &, const std::string &) const;           \
  template Number Hdf5Reader::attribute(const std::string &, const std::string &) const

  INSTANTIATE(double);
  INSTANTIATE(int);
  INSTANTIATE(unsigned int);
  INSTANTIATE(std::string);
#undef INSTANTIATE
} // namespace ringmotor
