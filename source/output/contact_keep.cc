// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/timer.h>

#include <ringmotor/motor/relevant.h>
#include <ringmotor/output/contact_keep.h>
#include <ringmotor/output/files.h>
#include <ringmotor/output/kept_file.h>
#include <ringmotor/output/text.h>
#include <ringmotor/parameters/errors.h>
#include <ringmotor/parameters/fingerprint.h>

#include <filesystem>

namespace ringmotor
{
  using namespace dealii;
  namespace fs = std::filesystem;

  namespace
  {
    /** Bytes of all files below a folder, zero if there is no such folder. */
    std::uintmax_t size_of(const fs::path &folder)
    {
      std::uintmax_t size = 0;
      std::error_code no_throw;
      for (const fs::directory_entry &entry : fs::recursive_directory_iterator(folder, no_throw))
        if (entry.is_regular_file(no_throw))
          size += entry.file_size(no_throw);
      return size;
    }

    std::string megabytes(const std::uintmax_t bytes)
    {
      return text(1e-6 * bytes, 1) + " MB";
    }

    std::string key_of(const std::string &what, const Parameters &relevant, const std::string &wave,
                       const unsigned int level)
    {
      return what + " by " + this_build() + "wave " + wave + "\ninterface mesh " +
             std::to_string(level) + "\n" + text_of(relevant);
    }
  } // namespace

  std::string condensation_key(const Parameters &parameters, const StatorWave &wave,
                               const unsigned int level)
  {
    return key_of("condensed motor", relevant_for_condensation(parameters), wave.fingerprint,
                  level);
  }

  std::string points_key(const Parameters &parameters, const StatorWave &wave,
                         const unsigned int level)
  {
    return key_of("operating point", relevant_for_points(parameters), wave.identity(), level);
  }

  /** Points found on one motor, as files. */
  class ContactKeep::Points : public PointMemory
  {
  public:
    Points(const std::string &folder, const std::string &key, Counts &counts)
        : folder(folder), key(key), counts(counts)
    {
    }

    std::optional<CurvePoint> recall(const PointRequest &request) override
    {
      const std::string its_key = key_for(request);
      const KeptContent kept    = read_kept_file(path_for(its_key), its_key);
      if (!kept.problem.empty())
        ++counts.damaged;
      if (!kept.bytes)
        return {};
      ++counts.recalled;
      return from_bytes<CurvePoint>(*kept.bytes);
    }

    void keep(const CurvePoint &point) override
    {
      replace(point);
      ++counts.found;
    }

    void replace(const CurvePoint &point) override
    {
      const std::string its_key = key_for(point.request);
      write_kept_file(path_for(its_key), its_key, to_bytes(point));
    }

  private:
    std::string key_for(const PointRequest &request) const { return key + request.text() + "\n"; }
    std::string path_for(const std::string &its_key) const { return folder + fingerprint(its_key); }

    const std::string folder, key;
    Counts &counts;
  };

  ContactKeep::ContactKeep(const std::string &folder, const Parameters &parameters,
                           const StatorWave &wave, const bool resumes, Log &log,
                           const MPI_Comm communicator)
      : motors(folder + "kept/"), points_folder(motors + "points/"), parameters(parameters),
        wave(wave), resumes(resumes), log(log), communicator(communicator)
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
    {
      std::error_code no_throw;
      if (!resumes)
        fs::remove_all(points_folder, no_throw);
      prepare_directory(points_folder);
      if (resumes)
        log.line("resuming with the operating points in " + points_folder);
    }
    Utilities::MPI::broadcast(communicator, 0); // no rank continues before the folders exist
  }

  ContactKeep::Place ContactKeep::place_of(const unsigned int level,
                                           const std::optional<unsigned int> &modes_level) const
  {
    const std::string modes = modes_level ? "_modes_" + std::to_string(*modes_level) : "";
    return {motors + "interface_mesh_" + std::to_string(level) + modes,
            condensation_key(parameters, wave, level) + modes};
  }

  std::optional<TimedMotor>
  ContactKeep::recall_motor(const unsigned int level,
                            const std::optional<unsigned int> &modes_level)
  {
    const auto [path, key] = place_of(level, modes_level);
    Timer timer;
    KeptContent kept;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      kept = read_kept_file(path, key);
    if (!kept.problem.empty())
      log.line("kept condensation " + path + " " + kept.problem + ": computed anew");
    const std::string bytes =
        Utilities::MPI::broadcast(communicator, kept.bytes.value_or(std::string()));
    if (bytes.empty())
      return {};
    log.line("condensation of interface mesh " + std::to_string(level) + " read from " + path);
    return TimedMotor{from_bytes<CondensedMotor>(bytes), timer.wall_time()};
  }

  void ContactKeep::keep_motor(const unsigned int level,
                               const std::optional<unsigned int> &modes_level,
                               const CondensedMotor &motor)
  {
    const auto [path, key] = place_of(level, modes_level);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      write_kept_file(path, key, to_bytes(motor));
  }

  std::unique_ptr<PointMemory> ContactKeep::points(const Parameters &varied,
                                                   const Discretisation &discretisation)
  {
    const std::string key = points_key(varied, wave, discretisation.level) + discretisation.text() +
                            "\nmodes " + std::to_string(discretisation.modes_level) + "\n";
    return std::make_unique<Points>(points_folder, key, counts);
  }

  void ContactKeep::report()
  {
    const unsigned int n_found    = Utilities::MPI::sum(counts.found, communicator),
                       n_recalled = Utilities::MPI::sum(counts.recalled, communicator),
                       n_damaged  = Utilities::MPI::sum(counts.damaged, communicator);
    if (n_damaged > 0)
      log.line(std::to_string(n_damaged) + " kept operating points were damaged: computed anew");
    if (resumes)
      log.line("resumed: " + std::to_string(n_recalled) + " operating points, including those " +
               "for error bars, were available; " +
               (n_found == 0 ? "nothing was left to compute"
                             : std::to_string(n_found) + " were computed"));
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      log.line("kept for later runs: " + megabytes(size_of(motors)) + " in " + motors +
               " (contact --clear removes them)");
  }

  void ContactKeep::clear(const std::string &folder)
  {
    const std::string kept = folder + "kept/";
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    const std::uintmax_t size = size_of(kept);
    std::error_code error;
    fs::remove_all(kept, error);
    if (error)
      throw UserError("cannot remove " + kept + ": " + error.message() + "; check its permissions");
    Log(true).line("removed " + megabytes(size) + " in " + kept);
  }
} // namespace ringmotor
