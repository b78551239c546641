// SPDX-License-Identifier: LGPL-2.1-or-later
#include <ringmotor/mesh/ids.h>
#include <ringmotor/structure/cyclic_sector.h>
#include <ringmotor/structure/sector_mass.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace ringmotor
{
  using namespace dealii;

  CyclicSector::CyclicSector(const SectorMesh &mesh, const MaterialTable &materials,
                             const unsigned int degree, const LowerElectrode lower_electrode)
      : SectorElements(mesh, materials, degree, lower_electrode)
  {
    for (auto &field_terms : terms)
      field_terms.resize(n_dofs());
    switch (mesh.form)
    {
    case SectorForm::half:
      number_half_sector();
      break;
    case SectorForm::whole:
      number_whole_sector();
      break;
    case SectorForm::ring:
      number_ring();
      break;
    }
    number_fields();
  }

  CyclicSector::~CyclicSector() = default;

  void CyclicSector::number_half_sector()
  {
    using Factor                             = Term::Factor;
    std::array<std::vector<Terms>, 2> &field = terms;

    for (Dof dof = 0; dof < n_dofs(); ++dof)
    {
      if (dependent().is_constrained(dof))
        continue;
      const bool turned = nodes().turned_by_mirror(dof);
      if (nodes().on(dof, ids::mirror)) // there, r and theta are x and y
        field[turned ? 1 : 0][dof].add(unknown_count++, Factor::one);
      else if (nodes().on(dof, ids::cut))
      {
        field[0][dof].add(unknown_count, turned ? Factor::sine : Factor::cosine);
        field[1][dof].add(unknown_count, turned ? Factor::cosine : Factor::minus_sine);
        ++unknown_count;
      }
      else
      {
        field[0][dof].add(unknown_count++, Factor::one);
        field[1][dof].add(unknown_count++, Factor::one);
      }
    }
  }

  void CyclicSector::number_whole_sector()
  {
    using Factor = Term::Factor;

    const auto is_master = [&](const Dof dof)
    { return !dependent().is_constrained(dof) && !nodes().on(dof, ids::cut_high); };
    unsigned int n_complex = 0;
    for (Dof dof = 0; dof < n_dofs(); ++dof)
      n_complex += is_master(dof);
    unknown_count = 2 * n_complex;

    unsigned int next = 0;
    for (Dof dof = 0; dof < n_dofs(); ++dof)
      if (is_master(dof))
      {
        terms[0][dof].add(next, Factor::one);
        terms[1][dof].add(n_complex + next, Factor::one);
        ++next;
      }

    // exp(-i k alpha) (a + i b) = (c a + s b) + i (c b - s a)
    for (const auto &[high, low] : nodes().partners(dependent()))
    {
      const unsigned int real      = terms[0][low].term[0].unknown;
      const unsigned int imaginary = terms[1][low].term[0].unknown;
      terms[0][high].add(real, Factor::cosine);
      terms[0][high].add(imaginary, Factor::sine);
      terms[1][high].add(imaginary, Factor::cosine);
      terms[1][high].add(real, Factor::minus_sine);
    }
  }

  void CyclicSector::number_ring()
  {
    for (Dof dof = 0; dof < n_dofs(); ++dof)
      if (!dependent().is_constrained(dof))
        terms[0][dof].add(unknown_count++, Term::Factor::one);
  }

  void CyclicSector::number_fields()
  {
    std::vector<bool> tied(unknown_count, false); // to a factor that depends on k
    for (const auto &field_terms : terms)
      for (const Terms &of_dof : field_terms)
        for (unsigned int i = 0; i < of_dof.size; ++i)
          if (of_dof.term[i].factor != Term::Factor::one)
            tied[of_dof.term[i].unknown] = true;

    std::vector<bool> is_potential(unknown_count, false);
    for (const auto &field_terms : terms)
      for (Dof dof = nodes().first_potential_dof(); dof < n_dofs(); ++dof)
        for (unsigned int i = 0; i < field_terms[dof].size; ++i)
          is_potential[field_terms[dof].term[i].unknown] = true;
    potential_unknown_count = std::count(is_potential.begin(), is_potential.end(), true);

    for (unsigned int part = 0; part < 2; ++part)
    {
      RealField &field = fields[part];
      field.number.assign(n_dofs(), numbers::invalid_unsigned_int);
      for (Dof dof = 0; dof < n_dofs(); ++dof)
        if (const Terms &of_dof = terms[part][dof]; of_dof.size > 0)
        {
          field.number[dof] = field.size++;
          if (tied[of_dof.term[0].unknown])
            field.cut.push_back(field.number[dof]);
          else
            field.inner.emplace_back(field.number[dof], of_dof.term[0].unknown);
        }
    }
  }

  CyclicSector::WaveFunctions CyclicSector::wave_functions(const unsigned int k) const
  {
    const double pitch = 2. * numbers::PI / sector_mesh().n_sectors;
    const double angle = k * (sector_mesh().form == SectorForm::half ? 0.5 * pitch : pitch);
    return {{1., std::cos(angle), std::sin(angle)}};
  }

  std::vector<CyclicSector::Tie> CyclicSector::ties(const unsigned int part,
                                                    const WaveFunctions &values) const
  {
    const std::array<double, 4> factor = factors(values);
    const RealField &field             = fields[part];
    std::vector<Tie> ties;
    unsigned int position = 0;
    for (Dof dof = 0; dof < n_dofs(); ++dof)
      if (position < field.cut.size() && field.number[dof] == field.cut[position])
      {
        const Terms &of_dof = terms[part][dof];
        for (unsigned int i = 0; i < of_dof.size; ++i)
          ties.push_back({position, of_dof.term[i].unknown,
                          factor[static_cast<unsigned int>(of_dof.term[i].factor)]});
        ++position;
      }
    return ties;
  }

  std::array<Vector<double>, 2> CyclicSector::fields_of(const unsigned int k,
                                                        const std::vector<double> &unknowns) const
  {
    const std::array<double, 4> factor = factors(wave_functions(k));
    std::array<Vector<double>, 2> fields;
    for (unsigned int part = 0; part < 2; ++part)
    {
      fields[part].reinit(n_dofs());
      for (Dof dof = 0; dof < n_dofs(); ++dof)
        for (unsigned int i = 0; i < terms[part][dof].size; ++i)
        {
          const Term &term = terms[part][dof].term[i];
          fields[part][dof] +=
              factor[static_cast<unsigned int>(term.factor)] * unknowns[term.unknown];
        }
    }
    return fields;
  }

  std::vector<double>
  CyclicSector::to_unknowns(const unsigned int k,
                            const std::array<Vector<double>, 2> &dof_loads) const
  {
    const std::array<double, 4> factor = factors(wave_functions(k));
    std::vector<double> loads(unknown_count, 0.);
    for (unsigned int part = 0; part < 2; ++part)
      for (Dof dof = 0; dof < n_dofs(); ++dof)
      {
        const Terms &of_dof = terms[part][dof];
        for (unsigned int i = 0; i < of_dof.size; ++i)
          loads[of_dof.term[i].unknown] +=
              factor[static_cast<unsigned int>(of_dof.term[i].factor)] * dof_loads[part][dof];
      }
    return loads;
  }

  void CyclicSector::multiply_mass(const unsigned int k, const std::vector<double> &unknowns,
                                   std::vector<double> &product) const
  {
    if (!mass)
      mass = std::make_unique<SectorMass>(*this);
    const unsigned int n = n_fields();
    std::vector<double> fields; // of each vector the real one, then the imaginary one
    fields.reserve(unknowns.size() / unknown_count * n * n_dofs());
    for (auto vector = unknowns.begin(); vector != unknowns.end(); vector += unknown_count)
    {
      const auto of_vector = fields_of(k, {vector, vector + unknown_count});
      for (unsigned int part = 0; part < n; ++part)
        fields.insert(fields.end(), of_vector[part].begin(), of_vector[part].end());
    }
    const std::vector<double> products = mass->multiply(fields);
    product.clear();
    product.reserve(unknowns.size());
    for (auto next = products.begin(); next != products.end();)
    {
      std::array<Vector<double>, 2> of_vector;
      for (unsigned int part = 0; part < n; ++part)
      {
        of_vector[part].reinit(n_dofs());
        std::copy_n(next, n_dofs(), of_vector[part].begin());
        next += n_dofs();
      }
      const std::vector<double> of_unknowns = to_unknowns(k, of_vector);
      product.insert(product.end(), of_unknowns.begin(), of_unknowns.end());
    }
    Utilities::MPI::sum(product, communicator(), product);
  }

  std::vector<double>
  CyclicSector::unknowns_of(const unsigned int k,
                            const std::function<NodeMotion(const Point<3> &)> &motion) const
  {
    std::array<Vector<double>, 2> fields{{Vector<double>(n_dofs()), Vector<double>(n_dofs())}};
    nodes().interpolate(motion, fields[0], fields[1]);

    // The degrees of freedom are known combinations of the unknowns: least squares inverts that.
    const std::array<double, 4> factor = factors(wave_functions(k));
    std::vector<double> unknowns       = to_unknowns(k, fields), weights(unknown_count, 0.);
    for (unsigned int part = 0; part < 2; ++part)
      for (const Terms &of_dof : terms[part])
        for (unsigned int i = 0; i < of_dof.size; ++i)
          weights[of_dof.term[i].unknown] +=
              std::pow(factor[static_cast<unsigned int>(of_dof.term[i].factor)], 2);
    for (unsigned int i = 0; i < unknown_count; ++i)
      unknowns[i] /= weights[i];
    return unknowns;
  }

  SectorMotion CyclicSector::expand(const unsigned int k, const std::vector<double> &unknowns) const
  {
    return to_motion(fields_of(k, unknowns));
  }

  std::vector<double> CyclicSector::loads_of(const unsigned int k, const SectorMotion &forces) const
  {
    return to_unknowns(k, from_forces(forces));
  }
} // namespace ringmotor
