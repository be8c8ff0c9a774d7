#include <signorini/input/input_error.h>
#include <signorini/variational_inequality/interface_problem_io.h>

#include <cmath>
#include <cstdlib>
#include <istream>
#include <limits>
#include <ostream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr const char *title = "Signorini interface problem 2";

    // More DoFs than any dense interface can have: a damaged number should
    // not end in an allocation of terabytes.
    constexpr unsigned int largest_size = 100000;

    class Reader
    {
    public:
      Reader(std::istream &in, const std::string &name)
        : in(in)
        , name(name)
      {}

      [[noreturn]] void
      fail(const std::string &expected) const
      {
        throw InputError(name + ": expected " + expected +
                         ", found something else. The file is damaged or not "
                         "an interface problem; write it again.");
      }

      void
      expect_title() const
      {
        std::string line;
        std::getline(in, line);
        if (line != title)
          fail(std::string("the first line `") + title + "'");
      }

      void
      expect(const std::string &keyword) const
      {
        std::string word;
        if (!(in >> word) || word != keyword)
          fail("the word `" + keyword + "'");
      }

      // A stream does not read `inf', which is allowed for some numbers.
      double
      number(const std::string &what, const bool may_be_infinite = false) const
      {
        std::string word;
        in >> word;
        char        *end   = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (word.empty() || *end != '\0' ||
            !(std::isfinite(value) || (may_be_infinite && value > 0.)))
          fail("a number for " + what);
        return value;
      }

      double
      not_negative(const std::string &what, const bool may_be_infinite) const
      {
        const double value = number(what, may_be_infinite);
        if (value < 0.)
          fail(what + " that is not negative");
        return value;
      }

      unsigned int
      count(const std::string &what, const unsigned int bound) const
      {
        long value = 0;
        if (!(in >> value) || value < 0 || value > static_cast<long>(bound))
          fail(what + ", between 0 and " + std::to_string(bound));
        return value;
      }

      // A size may be wrong, and the memory for it not there.
      void
      expect_numbers(const double n, const std::string &what) const
      {
        const std::istream::pos_type here = in.tellg();
        in.seekg(0, std::ios::end);
        const double left = in.tellg() - here;
        in.seekg(here);
        if (left < 2. * n - 1.) // a digit and a blank each
          fail("as many numbers of " + what + " as the size asks for");
      }

    private:
      std::istream      &in;
      const std::string &name;
    };

    void
    read_stiffness(const Reader      &reader,
                   const unsigned int n,
                   InterfaceProblem  &problem)
    {
      reader.expect_numbers(0.5 * n * (n + 1.), "the factor");
      std::vector<double> lower(std::size_t(n) * n, 0.);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          lower[i + std::size_t(j) * n] = reader.number("the factor");
      for (unsigned int i = 0; i < n; ++i)
        if (lower[i + std::size_t(i) * n] <= 0.)
          reader.fail("a positive diagonal of the factor");
      problem.set_stiffness(InterfaceStiffness::from_cholesky_factor(n, lower));
    }

    SparseRow
    read_row(const Reader &reader, const unsigned int n)
    {
      SparseRow          row;
      const unsigned int n_entries =
        reader.count("a number of entries", largest_size);
      for (unsigned int entry = 0; entry < n_entries; ++entry)
        {
          const unsigned int dof = reader.count("a DoF", n > 0 ? n - 1 : 0);
          row.add(dof, reader.number("a coefficient"));
        }
      return row;
    }

    InterfaceContact
    read_contact(const Reader &reader, const unsigned int n)
    {
      InterfaceContact contact;
      contact.gap    = reader.number("a gap", /*may_be_infinite=*/true);
      contact.normal = read_row(reader, n);
      contact.friction_coefficient =
        reader.not_negative("a friction coefficient", false);
      contact.largest_friction =
        reader.not_negative("a largest friction", true);
      const unsigned int n_tangents = reader.count("a number of tangents", 2);
      for (unsigned int j = 0; j < n_tangents; ++j)
        {
          contact.slip[j] = reader.number("a slip");
          contact.tangents.push_back(read_row(reader, n));
        }
      return contact;
    }

    void
    write_row(const SparseRow &row, std::ostream &out)
    {
      out << ' ' << row.size();
      for (const auto &[dof, coefficient] : row)
        out << ' ' << dof << ' ' << coefficient;
      out << '\n';
    }
  } // namespace



  void
  write_interface_problem(const InterfaceProblem &problem, std::ostream &out)
  {
    const std::streamsize old_precision =
      out.precision(std::numeric_limits<double>::max_digits10);
    out << title << "\nsize " << problem.size() << "\ncontacts "
        << problem.n_contacts() << "\nfactor\n";
    for (unsigned int i = 0; i < problem.size(); ++i)
      for (unsigned int j = 0; j <= i; ++j)
        out << problem.stiffness().factor(i, j) << (j < i ? ' ' : '\n');
    out << "force\n";
    for (const double force : problem.force())
      out << force << '\n';
    out << "rows\n";
    for (unsigned int k = 0; k < problem.n_contacts(); ++k)
      {
        const InterfaceContact &contact = problem.contact(k);
        out << contact.gap;
        write_row(contact.normal, out);
        out << contact.friction_coefficient << ' ' << contact.largest_friction
            << ' ' << contact.tangents.size() << '\n';
        for (unsigned int j = 0; j < contact.tangents.size(); ++j)
          {
            out << contact.slip[j];
            write_row(contact.tangents[j], out);
          }
      }
    out << "end" << std::endl;
    out.precision(old_precision);
    if (!out)
      throw ComputationError("An interface problem could not be written. The "
                             "disk may be full.");
  }



  InterfaceProblem
  read_interface_problem(std::istream &in, const std::string &name)
  {
    const Reader reader(in, name);
    reader.expect_title();
    reader.expect("size");
    const unsigned int n = reader.count("the size", largest_size);
    reader.expect("contacts");
    const unsigned int n_contacts =
      reader.count("the number of contacts", largest_size);

    InterfaceProblem problem;
    reader.expect("factor");
    read_stiffness(reader, n, problem);

    reader.expect("force");
    InterfaceVector force(n);
    for (double &entry : force)
      entry = reader.number("the force");
    problem.set_force(force);

    reader.expect("rows");
    std::vector<InterfaceContact> contacts;
    for (unsigned int k = 0; k < n_contacts; ++k)
      contacts.push_back(read_contact(reader, n));
    problem.set_contacts(std::move(contacts));
    reader.expect("end");
    return problem;
  }
} // namespace Signorini
