// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <H5Ipublic.h>

#include <cstddef>
#include <string>
#include <vector>

namespace ringmotor
{
  /** Owns one HDF5 identifier of any kind (file, dataset, type, ...) and closes it. */
  class Hdf5Handle
  {
  public:
    explicit Hdf5Handle(const hid_t id) : id(id) {}
    Hdf5Handle(const Hdf5Handle &)            = delete;
    Hdf5Handle &operator=(const Hdf5Handle &) = delete;
    ~Hdf5Handle()
    {
      if (is_valid())
        H5Idec_ref(id);
    }

    operator hid_t() const { return id; }
    bool is_valid() const { return id >= 0; }

  private:
    const hid_t id;
  };

  /**
   * Builds an HDF5 file in memory and writes it all or nothing. The root carries the attributes
   * `format` and `format_version`, every dataset `unit` and `description`.
   *
   * Value types: double, int, unsigned int, std::string (UTF-8; all texts of a dataset are padded
   * to the longest, h5py shows them as bytes). Names are paths such as `mode/frequency`; groups on
   * the way are created. Datasets carry checksums and are limited to 4 GB each.
   *
   * All members throw ComputationError if HDF5 fails, e.g. when memory runs out or a name is
   * used twice.
   */
  class Hdf5Writer
  {
  public:
    /** @param format what the file holds, e.g. "ringmotor modes"
     *  @param format_version grows by one whenever a reader has to change */
    Hdf5Writer(const std::string &format, unsigned int format_version);

    /**
     * Adds a dataset.
     *
     * @param values    row-major, as many as the product of @p dims (1 if there are none)
     * @param unit      SI unit such as "m", "N/m", "1" for a pure number or a count, "" for texts
     * @param description one sentence: meaning, sign, frame, what each dimension runs over
     */
    template <typename Number>
    void write(const std::string &name, const std::vector<Number> &values,
               const std::vector<std::size_t> &dims, const std::string &unit,
               const std::string &description);

    /** Adds a scalar attribute to a group or dataset (`/` is the root; a missing group is created).
     */
    template <typename Number>
    void set_attribute(const std::string &object, const std::string &name, const Number &value);

    /** Writes the file with write_file().
     *  @throw UserError if writing fails */
    void save(const std::string &path) const;

  private:
    Hdf5Handle file;
  };

  /**
   * Reads a file of Hdf5Writer. Every mismatch, a missing or damaged file included, is a UserError
   * in one line: the file, the dataset or attribute, what was found and what was expected. Numbers
   * that are not finite are refused as well.
   */
  class Hdf5Reader
  {
  public:
    /** Stands for a size in `dims` that may be anything. */
    static constexpr std::size_t any_size = static_cast<std::size_t>(-1);

    /** Opens a file that must be of this format and version, see Hdf5Writer. */
    Hdf5Reader(const std::string &path, const std::string &format, unsigned int format_version);

    /** Whether the root has a group or dataset of this name. */
    bool has(const std::string &name) const;

    /** The sizes of a dataset. */
    std::vector<std::size_t> dims(const std::string &name) const;

    /** Reads a dataset that must have these sizes (see any_size) and this unit. Row-major. */
    template <typename Number>
    std::vector<Number> read(const std::string &name, const std::vector<std::size_t> &dims,
                             const std::string &unit) const;

    /** Reads a scalar attribute of a group or dataset. */
    template <typename Number>
    Number attribute(const std::string &object, const std::string &name) const;

    /** The same of a number that must be between two others, both included. */
    template <typename Number>
    Number attribute_between(const std::string &object, const std::string &name, const Number least,
                             const Number most) const;

  private:
    const std::string path;
    const Hdf5Handle file;
  };
} // namespace ringmotor
