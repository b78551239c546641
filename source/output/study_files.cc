// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/output/files.h>
#include <ringmotor/output/kept_file.h>
#include <ringmotor/output/study_files.h>
#include <ringmotor/output/table.h>
#include <ringmotor/output/text.h>
#include <ringmotor/parameters/fingerprint.h>

#include <algorithm>
#include <filesystem>

namespace ringmotor
{
  using namespace dealii;

  namespace
  {
    constexpr double next_digit_from = 1e-2, next_digit_to = 1e-3;

    /** `flange solid (another model), 0.52 s`. */
    std::string describe(const StudyRow &row)
    {
      std::string text = row.knob + (row.value.empty() ? "" : " " + row.value) +
                         (row.is_other_model ? " (another model)" : "") + ", " +
                         ringmotor::text(row.seconds, 2) + " s";
      return row.results.empty() ? text + ", no solution" : text;
    }

    std::string describe_counts(const StudyRow &row)
    {
      std::string text;
      for (const auto &[name, count] : row.counts)
        text += ", " + name + " " + std::to_string(count);
      std::replace(text.begin(), text.end(), '_', ' ');
      return text;
    }
  } // namespace

  void write_study(const std::string &path, const WorkPrecision &study)
  {
    const unsigned int n_quantities = study.quantities().size();
    std::vector<std::string> fronts(study.rows().size()); // names of quantities, by row
    for (unsigned int quantity = 0; quantity < n_quantities; ++quantity)
      for (const unsigned int row : study.front(quantity))
        fronts[row] += (fronts[row].empty() ? "" : " ") + study.quantities()[quantity].name;

    std::vector<NamedRow> table;
    for (unsigned int i = 0; i < study.rows().size(); ++i)
    {
      const StudyRow &row = study.rows()[i];
      NamedRow entries{
          {"knob", row.knob}, {"value", row.value}, {"other_model", row.is_other_model ? 1u : 0u}};
      for (const auto &[name, count] : row.counts)
        entries.emplace_back(name, count);
      entries.emplace_back("seconds", row.seconds);
      for (unsigned int quantity = 0; quantity < n_quantities; ++quantity)
      {
        const std::optional<double> distance = study.distance(i, quantity);
        entries.emplace_back("distance_" + study.quantities()[quantity].name,
                             distance ? CsvTable::Entry(*distance) : CsvTable::Entry(""));
      }
      entries.emplace_back("pareto_front", fronts[i]);
      table.push_back(entries);
    }
    write_table(path, table);
  }

  std::vector<std::string> describe(const WorkPrecision &study)
  {
    std::vector<std::string> lines;
    for (unsigned int quantity = 0; quantity < study.quantities().size(); ++quantity)
    {
      const std::string of = " for " + study.quantities()[quantity].name + " to ";
      for (const double tolerance : {1e-2, 3e-3, 1e-3})
      {
        const auto row = study.cheapest(quantity, tolerance);
        lines.push_back(row ? "cheapest" + of + scientific(tolerance) + ": " +
                                  describe(study.rows()[*row])
                            : "no setting" + of + scientific(tolerance));
      }
      if (const auto price = study.price(quantity, next_digit_from, next_digit_to))
        lines.push_back("the next digit of " + study.quantities()[quantity].name + ", from " +
                        scientific(next_digit_from) + " to " + scientific(next_digit_to) +
                        ", takes " + text(*price, 1) + " times as long");
    }
    return lines;
  }

  StudyKeep::StudyKeep(const std::string &folder, const bool resumes, Log &log,
                       const MPI_Comm communicator)
      : folder(folder), resumes(resumes),
        is_root_rank(Utilities::MPI::this_mpi_process(communicator) == 0), log(log),
        communicator(communicator)
  {
    if (!is_root_rank)
      return;
    std::error_code no_throw;
    if (!resumes)
      std::filesystem::remove_all(folder, no_throw);
    prepare_directory(folder);
  }

  StudyRow StudyKeep::row(const std::string &key, const std::function<StudyRow()> &compute)
  {
    const std::string whole_key = "row of a study by " + this_build() + key;
    const std::string path      = folder + fingerprint(whole_key);
    KeptContent kept;
    if (is_root_rank)
      kept = read_kept_file(path, whole_key);
    if (!kept.problem.empty())
      ++n_damaged;
    const std::string bytes =
        Utilities::MPI::broadcast(communicator, kept.bytes.value_or(std::string()));
    if (!bytes.empty())
    {
      ++n_recalled;
      return from_bytes<StudyRow>(bytes);
    }
    const StudyRow row = compute();
    ++n_computed;
    if (is_root_rank)
      write_kept_file(path, whole_key, to_bytes(row));
    log.line(describe(row) + describe_counts(row));
    return row;
  }

  void StudyKeep::report()
  {
    if (n_damaged > 0)
      log.line(std::to_string(n_damaged) + " kept settings were damaged: computed anew");
    if (resumes)
      log.line("resumed: " + std::to_string(n_recalled) + " settings were available; " +
               (n_computed == 0 ? "nothing was left to compute"
                                : std::to_string(n_computed) + " were computed"));
  }
} // namespace ringmotor
