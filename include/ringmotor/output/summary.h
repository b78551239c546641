// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <ringmotor/motor/effect.h>
#include <ringmotor/motor/relevant.h>
#include <ringmotor/parameters/entries.h>
#include <ringmotor/results/quantity.h>
#include <ringmotor/structure/shared_work.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace ringmotor
{
  /** What a run computed, how accurately, and at what cost: the content of `summary.json`. */
  struct Summary
  {
    /** What distinguishes quantities of the same name, e.g. n = 7, family = "axial". */
    using Labels = std::map<std::string, std::variant<int, unsigned int, double, std::string>>;

    /** One result. */
    struct Result
    {
      Quantity quantity;
      double seconds = 0.;
      Labels labels  = {};
    };

    /** One check of the results: it holds if the value does not exceed the limit. */
    struct Check
    {
      std::string name;
      double value       = 0.;
      double limit       = 0.;
      std::string remedy = {}; ///< what a user can do if it does not hold; not written

      bool holds() const { return value <= limit; } ///< NaN does not
    };

    std::string program, version, git;
    std::string blas_kernel;     ///< see blas_kernel(); empty for a BLAS other than OpenBLAS
    std::string prm;             ///< the parameters of the run, as text
    Entries entries;             ///< the same, one by one
    Parameters::Variant variant; ///< what the file differs in from the one that it is based on
    Identity identity;           ///< of the motor, see identity_of()
    std::vector<std::pair<std::string, double>> seconds; ///< per phase, in the order of the run
    double peak_memory_MB = 0.;
    SharedSeconds ranks; ///< by the number of MPI processes
    std::uint64_t dofs = 0;
    std::vector<Result> results;
    std::vector<EffectRow> effects;
    std::vector<Check> certificate;
  };

  /** @param seconds spent on finding them */
  void add_quantities(Summary &summary, const std::vector<Quantity> &quantities,
                      const double seconds, const Summary::Labels &labels = {});

  /** `Effects/Rotor inertia = auto: on; it changes the results by 31 %` */
  std::string describe(const EffectRow &row);

  /** True if there is at least one check and all of them hold. */
  bool is_certified(const Summary &summary);

  /**
   * Writes a summary as JSON with the keys named as the members above; `seconds` is an object with
   * one key per phase, and `certificate` is an object with `holds` (see is_certified()) and
   * `checks`. Results with known errors are listed as `quantities`, others as
   * `quantities_without_error`; their labels stand beside their names. The latter is left out if it
   * is empty, and so is `variant` for a file that is based on no other.
   *
   * @throw ComputationError for a number that is not finite, naming it: no file is written
   * @throw UserError if writing fails
   */
  void write_summary(const std::string &path, const Summary &summary);
} // namespace ringmotor
