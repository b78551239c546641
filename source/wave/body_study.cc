// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/body_origin.h>
#include <ringmotor/motor/relevant.h>
#include <ringmotor/wave/body_study.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace ringmotor
{
  namespace
  {
    const std::string wave_frequency = "frequency";
    const std::vector<std::string> of_shape{"A_t/A_n", "phi_edge"};

    /** Collects the settings of a body. */
    class Collection
    {
    public:
      explicit Collection(const Parameters &parameters)
          : is_fixed(parameters.accuracy.mode == AccuracyMode::fixed),
            is_stator(parameters.modes.body == Body::stator),
            is_read(origin_of_modes(parameters).is_sector), stator(parameters.stator),
            highest_degree(is_fixed ? parameters.accuracy.polynomial_degree : 4),
            finest_level(is_fixed  ? parameters.accuracy.refinement
                         : is_read ? 1
                                   : 4)
      {
      }

      std::vector<BodySetting> collect()
      {
        for (unsigned int degree = 2; degree <= highest_degree; ++degree)
          for (unsigned int level = 0; level <= level_of(degree); ++level)
            add("degree " + std::to_string(degree), "refinement " + std::to_string(level),
                {degree, level});
        if (is_stator && !is_read)
        {
          add_gradings();
          add_even_cells();
          add_those_of_the_paper();
          if (stator.piezoceramic_thickness > 0.)
            add_other_ring();
        }
        add("best setting", "", {highest_degree + 1, level_of(highest_degree)});
        return all;
      }

    private:
      /** The finest level of the sequence for a degree: each level of a mesh that was read has
       * eight times the cells of the one before. */
      unsigned int level_of(const unsigned int degree) const
      {
        if (is_fixed || degree == 2)
          return finest_level;
        return is_read ? 0 : degree == 3 ? finest_level : finest_level - 1;
      }

      void add(const std::string &knob, const std::string &value,
               const BodyDiscretisation &discretisation)
      {
        all.push_back({knob, value, discretisation, stator.piezoceramic_element});
      }

      /** The common setting of those that differ in one knob. */
      unsigned int common_degree() const { return std::min(3u, highest_degree); }
      unsigned int common_level() const { return std::min(2u, finest_level); }

      void add_gradings()
      {
        for (unsigned int n = 0; n <= finest_level; ++n)
        {
          SectorGrading grading = SectorGrading::level(common_level());
          grading.n_layers      = n;
          add("layers at the slot root", std::to_string(n), {common_degree(), n, grading});
        }
        for (unsigned int n = 1; n <= 1 + finest_level; ++n)
        {
          SectorGrading grading = SectorGrading::level(common_level());
          grading.n_radial      = n;
          add("cells from inside to outside", std::to_string(n),
              {common_degree(), common_level(), grading});
        }
      }

      static SectorGrading even(const EvenCells &cells, const unsigned int n_radial)
      {
        SectorGrading grading;
        grading.n_radial = n_radial;
        grading.even     = cells;
        return grading;
      }

      void add_even_cells()
      {
        for (unsigned int degree = 2; degree <= common_degree(); ++degree)
          for (unsigned int n = 1; n <= std::min(5 - degree, 1 + finest_level); ++n)
            add("even cells",
                "degree " + std::to_string(degree) + ", division " + std::to_string(n),
                {degree, n, even({2 * n, n, 2 * n, 4 * n}, 2 * n)});
      }

      /** 576 solids for each tooth, half of which are meshed here. */
      void add_those_of_the_paper()
      {
        const std::string paper   = "as in the paper";
        const SectorGrading cells = even({3, 1, 4, 8}, 6);
        add(paper, "", {1, 0, cells});
        add(paper, "its degree alone", {1, finest_level});
        add(paper, "its cells alone", {common_degree(), 0, cells});
      }

      void add_other_ring()
      {
        const bool is_shell = stator.piezoceramic_element == ElementKind::shell;
        add("ceramic ring", is_shell ? "solid" : "shell", {common_degree(), common_level()});
        all.back().piezoceramic   = is_shell ? ElementKind::solid : ElementKind::shell;
        all.back().is_other_model = true;
      }

      const bool is_fixed, is_stator, is_read;
      const StatorGeometry &stator;
      const unsigned int highest_degree, finest_level;
      std::vector<BodySetting> all;
    };
  } // namespace

  std::vector<BodySetting> body_settings(const Parameters &parameters)
  {
    return Collection(parameters).collect();
  }

  BodyStudy::BodyStudy(const Parameters &parameters, MPI_Comm communicator)
      : parameters(parameters), communicator(communicator), all(body_settings(parameters))
  {
  }

  std::string BodyStudy::key(const BodySetting &setting) const
  {
    Parameters relevant = parameters;
    relevant.output     = {};
    return text_of(relevant) + setting.knob + " " + setting.value;
  }

  BodyModes &BodyStudy::body_with(const ElementKind piezoceramic)
  {
    std::unique_ptr<BodyModes> &body = bodies[piezoceramic];
    if (!body)
    {
      Parameters with_it                  = parameters;
      with_it.stator.piezoceramic_element = piezoceramic;
      body                                = std::make_unique<BodyModes>(with_it, communicator);
      body->locate();
    }
    return *body;
  }

  StudyRow BodyStudy::compute(const BodySetting &setting)
  {
    BodyModes &body = body_with(setting.piezoceramic);
    const ProcessorTime time;
    const Pass pass = body.compute(setting.discretisation);
    StudyRow row;
    row.knob               = setting.knob;
    row.value              = setting.value;
    row.is_other_model     = setting.is_other_model;
    row.counts             = {{"degree", pass.degree},
                              {"cells", static_cast<unsigned int>(pass.n_cells)},
                              {"dofs", pass.n_dofs}};
    row.seconds            = time.seconds();
    const WaveResult *wave = body.wave();
    const FoundMode &found = wave ? wave->found : body.search().modes().front();
    row.results.push_back({found.frequency.value});
    for (const std::string &name : of_shape)
    {
      row.results.emplace_back();
      if (wave)
        for (const Quantity &quantity : wave->shape)
          if (quantity.name == name)
            row.results.back().push_back(quantity.value());
    }
    return row;
  }

  WorkPrecision BodyStudy::compare(const std::vector<StudyRow> &rows) const
  {
    std::vector<WorkPrecision::Measure> measures{{wave_frequency, 1.}};
    for (const std::string &name : of_shape)
      measures.push_back({name, 1.});
    for (std::size_t i = 0; i < measures.size(); ++i)
      for (const double value : rows.back().results[i])
        measures[i].scale = std::abs(value);
    return {rows, measures, static_cast<unsigned int>(rows.size() - 1)};
  }
} // namespace ringmotor
