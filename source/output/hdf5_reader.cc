// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/hdf5.h>
#include <ringmotor/output/hdf5_types.h>
#include <ringmotor/parameters/errors.h>

#include <algorithm>
#include <cmath>
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

    std::string in_quotes(const std::string &text)
    {
      return "'" + text + "'";
    }

    std::string dataset_called(const std::string &name)
    {
      return "dataset " + in_quotes(name);
    }

    std::string attribute_called(const std::string &object, const std::string &name)
    {
      return "attribute " + in_quotes(name) + " of " + in_quotes(object);
    }

    bool are_finite(const std::vector<double> &values)
    {
      return std::all_of(values.begin(), values.end(),
                         [](const double value) { return std::isfinite(value); });
    }

    template <typename Value>
    bool are_finite(const std::vector<Value> &)
    {
      return true;
    }

    std::string to_text(const hid_t type)
    {
      if (H5Tis_variable_str(type) > 0)
        return "texts of variable length";
      switch (H5Tget_class(type))
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
        reject(path, "", "a damaged file, or another format", expected);
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

    template <typename Type>
    bool can_be_read(const hid_t stored)
    {
      return Type::accepts(H5Tget_class(stored)) && H5Tis_variable_str(stored) <= 0;
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
      reject(path, "", "the format " + in_quotes(found_format), in_quotes(format));
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

    const Hdf5Handle stored(H5Dget_type(dataset));
    if (!can_be_read<Type>(stored))
      reject(path, dataset_called(name), to_text(stored), Type::name);
    const std::vector<std::size_t> found_dims = sizes_of(dataset);
    if (!agree(found_dims, dims))
      reject(path, dataset_called(name), to_text(found_dims), to_text(dims));
    const auto found_unit = attribute<std::string>(name, "unit");
    if (found_unit != unit)
      reject(path, dataset_called(name), "the unit " + in_quotes(found_unit), in_quotes(unit));

    std::size_t n_values = 1;
    for (const std::size_t size : found_dims)
      n_values *= size;
    const Hdf5Handle type(Type::type_from(stored));
    auto buffer = Type::room_for(n_values, type);
    if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer.data()) < 0)
      reject(path, dataset_called(name), "values that cannot be read", "an undamaged file");
    if (!are_finite(buffer))
      reject(path, dataset_called(name), "values that are not finite", "numbers");
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
    const std::string owner = attribute_called(object, name);

    const bool exists = H5Aexists_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
    const Hdf5Handle attribute(
        exists ? H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT)
               : H5I_INVALID_HID);
    if (!attribute.is_valid())
      reject(path, owner, "nothing", "a value");

    const Hdf5Handle stored(H5Aget_type(attribute));
    const Hdf5Handle space(H5Aget_space(attribute));
    if (!can_be_read<Type>(stored) || H5Sget_simple_extent_npoints(space) != 1)
      reject(path, owner, to_text(stored), std::string("one value from ") + Type::name);

    const Hdf5Handle type(Type::type_from(stored));
    auto buffer = Type::room_for(1, type);
    if (H5Aread(attribute, type, buffer.data()) < 0)
      reject(path, owner, "a value that cannot be read", "an undamaged file");
    if (!are_finite(buffer))
      reject(path, owner, "a value that is not finite", "a number");
    return Type::from_buffer(buffer, 1).front();
  }

  template <typename Number>
  Number Hdf5Reader::attribute_between(const std::string &object, const std::string &name,
                                       const Number least, const Number most) const
  {
    const Number value = attribute<Number>(object, name);
    if (value < least || value > most)
      reject(path, attribute_called(object, name), std::to_string(value),
             "a number between " + std::to_string(least) + " and " + std::to_string(most));
    return value;
  }

  template unsigned int Hdf5Reader::attribute_between(const std::string &, const std::string &,
                                                      const unsigned int, const unsigned int) const;

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
