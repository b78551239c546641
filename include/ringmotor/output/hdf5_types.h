// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <hdf5.h>
#include <string>
#include <vector>

// The HDF5 representation of the values of hdf5.h, for its writer and its reader only.

namespace ringmotor
{
  /**
   * The HDF5 side of a value type:
   * - type_for() makes the type in which values are stored (the caller closes it),
   * - type_from() makes the type in which values stored as @p stored are read,
   * - to_buffer() and from_buffer() translate between values and what HDF5 writes or has read,
   *   room_for() is an empty buffer to read into,
   * - accepts() says which stored types can be read as this one,
   * - name is what to call such values in a message.
   */
  template <typename Number>
  struct Hdf5Type;

  /** Numbers need no translation. */
  template <typename Number>
  struct Hdf5NumberType
  {
    using Buffer = std::vector<Number>;
    static const Buffer &to_buffer(const std::vector<Number> &values) { return values; }
    static Buffer room_for(const std::size_t n_values, hid_t) { return Buffer(n_values); }
    static Buffer from_buffer(const Buffer &buffer, std::size_t) { return buffer; }
  };

  template <>
  struct Hdf5Type<double> : Hdf5NumberType<double>
  {
    static constexpr const char *name = "numbers";
    static hid_t type_for(const Buffer &) { return H5Tcopy(H5T_NATIVE_DOUBLE); }
    static hid_t type_from(hid_t) { return H5Tcopy(H5T_NATIVE_DOUBLE); }
    static bool accepts(const H5T_class_t stored)
    {
      return stored == H5T_FLOAT || stored == H5T_INTEGER;
    }
  };

  template <>
  struct Hdf5Type<int> : Hdf5NumberType<int>
  {
    static constexpr const char *name = "integers";
    static hid_t type_for(const Buffer &) { return H5Tcopy(H5T_NATIVE_INT); }
    static hid_t type_from(hid_t) { return H5Tcopy(H5T_NATIVE_INT); }
    static bool accepts(const H5T_class_t stored) { return stored == H5T_INTEGER; }
  };

  template <>
  struct Hdf5Type<unsigned int> : Hdf5NumberType<unsigned int>
  {
    static constexpr const char *name = "integers";
    static hid_t type_for(const Buffer &) { return H5Tcopy(H5T_NATIVE_UINT); }
    static hid_t type_from(hid_t) { return H5Tcopy(H5T_NATIVE_UINT); }
    static bool accepts(const H5T_class_t stored) { return stored == H5T_INTEGER; }
  };

  /**
   * UTF-8, all padded with zeros to the length of the longest: HDF5 keeps texts of variable length
   * in a heap without checksums and can crash on it when the file is damaged.
   */
  template <>
  struct Hdf5Type<std::string>
  {
    using Buffer                      = std::vector<char>;
    static constexpr const char *name = "texts";

    static hid_t type_for(const std::vector<std::string> &values)
    {
      const hid_t type = H5Tcopy(H5T_C_S1);
      H5Tset_size(type, length_of_longest(values));
      H5Tset_strpad(type, H5T_STR_NULLPAD);
      H5Tset_cset(type, H5T_CSET_UTF8);
      return type;
    }

    static hid_t type_from(const hid_t stored) { return H5Tcopy(stored); }

    static bool accepts(const H5T_class_t stored) { return stored == H5T_STRING; }

    static Buffer to_buffer(const std::vector<std::string> &values)
    {
      const std::size_t length = length_of_longest(values);
      Buffer buffer(values.size() * length, '\0');
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i].copy(buffer.data() + i * length, length);
      return buffer;
    }

    static Buffer room_for(const std::size_t n_values, const hid_t type)
    {
      return Buffer(n_values * H5Tget_size(type));
    }

    static std::vector<std::string> from_buffer(const Buffer &buffer, const std::size_t n_values)
    {
      std::vector<std::string> values;
      for (std::size_t i = 0; i < n_values; ++i)
      {
        const std::size_t length = buffer.size() / n_values;
        const char *first = buffer.data() + i * length, *last = first + length;
        values.emplace_back(first, std::find(first, last, '\0'));
      }
      return values;
    }

  private:
    /** At least 1, as HDF5 requires. */
    static std::size_t length_of_longest(const std::vector<std::string> &values)
    {
      std::size_t length = 1;
      for (const std::string &value : values)
        length = std::max(length, value.size());
      return length;
    }
  };
} // namespace ringmotor
