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
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>

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
      const std::string its_key = key_for(point.request);
      write_kept_file(path_for(its_key), its_key, to_bytes(point));
      ++counts.found;
    }

  private:
    std::string key_for(const PointRequest &request) const
    {
      std::ostringstream text;
      text << std::setprecision(std::numeric_limits<double>::max_digits10) << key
           << (request.control == Control::torque ? "torque " : "speed ") << request.value << "\n";
      return text.str();
    }
    std::string path_for(const std::string &its_key) const { return folder + fingerprint(its_key); }

    const std::string folder, key;
    Counts &counts;
  };

  ContactKeep::ContactKeep(const std::string &folder, const StatorWave &wave, const bool resumes,
                           Log &log, const MPI_Comm communicator)
      : motors(folder + "kept/"), points_folder(motors + "points/"), wave(wave), resumes(resumes),
        log(log), communicator(communicator)
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

  std::optional<TimedMotor> ContactKeep::read(const unsigned int level, const std::string &path,
                                              const std::string &key)
  {
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

  std::vector<TimedMotor> ContactKeep::condensed(const Parameters &parameters,
                                                 const std::vector<unsigned int> &levels,
                                                 const std::optional<unsigned int> &modes_level,
                                                 const Condense &condense)
  {
    const std::string modes = modes_level ? "_modes_" + std::to_string(*modes_level) : "";
    const auto its_path     = [&](const unsigned int level)
    { return motors + "interface_mesh_" + std::to_string(level) + modes; };
    const auto its_key = [&](const unsigned int level)
    { return condensation_key(parameters, wave, level) + modes; };

    std::map<unsigned int, TimedMotor> known;
    std::vector<unsigned int> missing;
    for (const unsigned int level : levels)
      if (std::optional<TimedMotor> kept = read(level, its_path(level), its_key(level)))
        known.emplace(level, std::move(*kept));
      else
        missing.push_back(level);
    if (!missing.empty())
    {
      std::vector<TimedMotor> computed = condense(missing);
      for (std::size_t i = 0; i < missing.size(); ++i)
      {
        if (Utilities::MPI::this_mpi_process(communicator) == 0)
          write_kept_file(its_path(missing[i]), its_key(missing[i]), to_bytes(computed[i].motor));
        known.emplace(missing[i], std::move(computed[i]));
      }
    }
    std::vector<TimedMotor> all;
    for (const unsigned int level : levels)
      all.push_back(std::move(known.at(level)));
    return all;
  }

  std::vector<CurvePoint>
  ContactKeep::points(const Parameters &parameters, const CondensedMotor &motor,
                      const CurveSetting &setting, const std::vector<PointRequest> &requests,
                      const std::function<void(const CurvePoint &)> &after_point,
                      const std::vector<CurvePoint> &starts)
  {
    const std::string key = points_key(parameters, wave, setting.level) + setting.text() +
                            "\nmodes " + std::to_string(motor.modes_level) + "\n" +
                            (setting.tells_window ? "with its window\n" : "");
    Points memory(points_folder, key, counts);
    return find_points(parameters, motor, setting, requests, communicator, after_point, &memory,
                       starts, wave.drive);
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
