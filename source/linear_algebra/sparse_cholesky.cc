#include <signorini/input/input_error.h>
#include <signorini/linear_algebra/sparse_cholesky.h>

#include <cholmod.h>

#include <numeric>

namespace Signorini
{
  using namespace dealii;

  // CHOLMOD's objects with the owner they need.
  namespace Cholmod
  {
    struct Common : cholmod_common
    {
      Common()
      {
        cholmod_start(this);
        print = 0;
      }

      ~Common()
      {
        cholmod_finish(this);
      }

      Common(const Common &) = delete;
      Common &
      operator=(const Common &) = delete;
    };

    template <typename T, int (*release)(T **, cholmod_common *)>
    struct Deleter
    {
      cholmod_common *common;
      void
      operator()(T *object) const
      {
        release(&object, common);
      }
    };
    template <typename T, int (*release)(T **, cholmod_common *)>
    using Handle = std::unique_ptr<T, Deleter<T, release>>;

    using Sparse = Handle<cholmod_sparse, cholmod_free_sparse>;
    using Factor = Handle<cholmod_factor, cholmod_free_factor>;
    using Dense  = Handle<cholmod_dense, cholmod_free_dense>;
  } // namespace Cholmod

  namespace
  {
    constexpr unsigned int left_out = static_cast<unsigned int>(-1);

    // The lower triangle of the pattern with unknown i at position
    // position[i], as compressed columns with sorted rows. `source`, if given,
    // receives for each entry of the pattern (row by row, as stored) its place
    // among the values, or left_out.
    Cholmod::Sparse
    lower_triangle(const SparsityPattern           &pattern,
                   const std::vector<unsigned int> &order,
                   const std::vector<unsigned int> &position,
                   const int                        xtype,
                   cholmod_common                  &common)
    {
      const unsigned int n         = order.size();
      std::size_t        n_entries = 0;
      for (unsigned int column = 0; column < n; ++column)
        for (auto entry = pattern.begin(order[column]);
             entry != pattern.end(order[column]);
             ++entry)
          if (position[entry->column()] != left_out &&
              position[entry->column()] >= column)
            ++n_entries;

      Cholmod::Sparse matrix(
        cholmod_allocate_sparse(n, n, n_entries, 1, 1, -1, xtype, &common),
        {&common});
      if (!matrix)
        throw ComputationError("Not enough memory for a stiffness matrix of " +
                               std::to_string(n) + " unknowns.");
      auto *const column_start = static_cast<int *>(matrix->p);
      auto *const rows         = static_cast<int *>(matrix->i);
      int         next         = 0;
      for (unsigned int column = 0; column < n; ++column)
        {
          column_start[column] = next;
          for (auto entry = pattern.begin(order[column]);
               entry != pattern.end(order[column]);
               ++entry)
            {
              const unsigned int row = position[entry->column()];
              if (row != left_out && row >= column)
                rows[next++] = row;
            }
          std::sort(rows + column_start[column], rows + next);
        }
      column_start[n] = next;
      return matrix;
    }

    std::vector<unsigned int>
    positions(const std::vector<unsigned int> &order, const unsigned int size)
    {
      std::vector<unsigned int> position(size, left_out);
      for (unsigned int i = 0; i < order.size(); ++i)
        position[order[i]] = i;
      return position;
    }

    // Nested dissection, postordered, of the unknowns given.
    std::vector<unsigned int>
    fill_reducing_order(const SparsityPattern           &pattern,
                        const std::vector<unsigned int> &unknowns)
    {
      if (unknowns.empty())
        return unknowns;
      Cholmod::Common common;
      common.nmethods             = 1;
      common.method[0].ordering   = CHOLMOD_NESDIS;
      common.postorder            = 1;
      common.supernodal           = CHOLMOD_SUPERNODAL;
      const auto            graph = lower_triangle(pattern,
                                        unknowns,
                                        positions(unknowns, pattern.n_rows()),
                                        CHOLMOD_PATTERN,
                                        common);
      const Cholmod::Factor factor(cholmod_analyze(graph.get(), &common),
                                   {&common});
      if (!factor)
        throw ComputationError(
          "CHOLMOD could not order the stiffness matrix (status " +
          std::to_string(common.status) + ").");
      const auto *const permutation = static_cast<const int *>(factor->Perm);
      std::vector<unsigned int> order(unknowns.size());
      for (unsigned int i = 0; i < order.size(); ++i)
        order[i] = unknowns[permutation[i]];
      return order;
    }
  } // namespace



  struct SparseCholesky::Implementation
  {
    Cholmod::Common           common;
    const SparsityPattern    *pattern = nullptr;
    std::vector<unsigned int> order;
    unsigned int              n_trailing = 0;
    Cholmod::Sparse           matrix{nullptr, {&common}};
    Cholmod::Factor           factor{nullptr, {&common}};
    Cholmod::Dense            workspace{nullptr, {&common}};

    // For each entry of the pattern, row by row: its place among the values of
    // `matrix`, or left_out.
    std::vector<unsigned int> target;

    void
    map_entries()
    {
      const auto        position     = positions(order, pattern->n_rows());
      const auto *const column_start = static_cast<int *>(matrix->p);
      const auto *const rows         = static_cast<int *>(matrix->i);
      target.clear();
      target.reserve(pattern->n_nonzero_elements());
      for (unsigned int i = 0; i < pattern->n_rows(); ++i)
        for (auto entry = pattern->begin(i); entry != pattern->end(i); ++entry)
          {
            const unsigned int column = position[i];
            const unsigned int row    = position[entry->column()];
            if (column == left_out || row == left_out || row < column)
              target.push_back(left_out);
            else
              target.push_back(std::lower_bound(rows + column_start[column],
                                                rows + column_start[column + 1],
                                                static_cast<int>(row)) -
                               rows);
          }
    }

    cholmod_dense
    view(DofVector &x) const
    {
      cholmod_dense dense = {};
      dense.nrow          = x.size();
      dense.ncol          = 1;
      dense.nzmax         = x.size();
      dense.d             = x.size();
      dense.x             = x.begin();
      dense.xtype         = CHOLMOD_REAL;
      dense.dtype         = CHOLMOD_DOUBLE;
      return dense;
    }
  };



  SparseCholesky::SparseCholesky()
    : implementation_(std::make_unique<Implementation>())
  {}



  SparseCholesky::~SparseCholesky() = default;



  void
  SparseCholesky::analyse(const SparsityPattern           &pattern,
                          const std::vector<bool>         &is_fixed,
                          const std::vector<unsigned int> &trailing)
  {
    AssertDimension(pattern.n_rows(), is_fixed.size());
    auto             &my = *implementation_;
    std::vector<bool> is_interior(is_fixed.size());
    for (unsigned int i = 0; i < is_fixed.size(); ++i)
      is_interior[i] = !is_fixed[i];
    for (const unsigned int i : trailing)
      {
        Assert(is_interior[i],
               ExcMessage("Trailing unknowns must be free and distinct."));
        is_interior[i] = false;
      }
    std::vector<unsigned int> interior;
    for (unsigned int i = 0; i < is_interior.size(); ++i)
      if (is_interior[i])
        interior.push_back(i);

    my.pattern    = &pattern;
    my.n_trailing = trailing.size();
    my.order      = fill_reducing_order(pattern, interior);
    my.order.insert(my.order.end(), trailing.begin(), trailing.end());

    my.common.nmethods           = 1;
    my.common.method[0].ordering = CHOLMOD_NATURAL;
    my.common.postorder          = 0; // it would move the trailing unknowns
    my.common.supernodal         = CHOLMOD_SUPERNODAL;
    my.matrix                    = lower_triangle(pattern,
                               my.order,
                               positions(my.order, pattern.n_rows()),
                               CHOLMOD_REAL,
                               my.common);
    my.factor.reset(cholmod_analyze(my.matrix.get(), &my.common));
    if (!my.factor)
      throw ComputationError("Not enough memory to factorise the stiffness "
                             "matrix of " +
                             std::to_string(my.order.size()) + " unknowns.");
    my.map_entries();
  }



  void
  SparseCholesky::factorise(const DofMatrix &matrix)
  {
    auto &my = *implementation_;
    Assert(&matrix.get_sparsity_pattern() == my.pattern,
           ExcMessage("The matrix is not on the analysed pattern."));
    auto *const values = static_cast<double *>(my.matrix->x);
    std::size_t index  = 0;
    for (const auto &entry : matrix)
      {
        if (my.target[index] != left_out)
          values[my.target[index]] = entry.value();
        ++index;
      }
    cholmod_factorize(my.matrix.get(), my.factor.get(), &my.common);
    if (my.common.status == CHOLMOD_NOT_POSDEF)
      throw NotPositiveDefinite(my.order[my.factor->minor]);
    if (my.common.status < CHOLMOD_OK)
      throw ComputationError(
        "CHOLMOD could not factorise the stiffness matrix of " +
        std::to_string(my.order.size()) + " unknowns (status " +
        std::to_string(my.common.status) +
        "; -2 means: not enough memory). Take a coarser mesh or a machine "
        "with more memory.");
    if (!my.workspace || my.workspace->nzmax < my.factor->maxesize)
      my.workspace.reset(
        cholmod_allocate_dense(std::max<std::size_t>(1, my.factor->maxesize),
                               1,
                               std::max<std::size_t>(1, my.factor->maxesize),
                               CHOLMOD_REAL,
                               &my.common));
  }



  const std::vector<unsigned int> &
  SparseCholesky::order() const
  {
    return implementation_->order;
  }



  void
  SparseCholesky::forward_substitution(DofVector &x) const
  {
    auto &my = *implementation_;
    AssertDimension(x.size(), my.order.size());
    cholmod_dense dense = my.view(x);
    cholmod_super_lsolve(my.factor.get(),
                         &dense,
                         my.workspace.get(),
                         &my.common);
  }



  void
  SparseCholesky::backward_substitution(DofVector &x) const
  {
    auto &my = *implementation_;
    AssertDimension(x.size(), my.order.size());
    cholmod_dense dense = my.view(x);
    cholmod_super_ltsolve(my.factor.get(),
                          &dense,
                          my.workspace.get(),
                          &my.common);
  }



  void
  SparseCholesky::solve(DofVector &x, const DofVector &b) const
  {
    const auto &order = implementation_->order;
    DofVector   y(order.size());
    for (unsigned int i = 0; i < order.size(); ++i)
      y[i] = b[order[i]];
    forward_substitution(y);
    backward_substitution(y);
    x = 0.;
    for (unsigned int i = 0; i < order.size(); ++i)
      x[order[i]] = y[i];
  }



  std::vector<double>
  SparseCholesky::trailing_factor() const
  {
    const auto         &my     = *implementation_;
    const auto         &factor = *my.factor;
    const int           first  = my.order.size() - my.n_trailing;
    const std::size_t   n      = my.n_trailing;
    std::vector<double> block(n * n);
    const auto *const   super_start = static_cast<const int *>(factor.super);
    const auto *const   row_start   = static_cast<const int *>(factor.pi);
    const auto *const   value_start = static_cast<const int *>(factor.px);
    const auto *const   rows        = static_cast<const int *>(factor.s);
    const auto *const   values      = static_cast<const double *>(factor.x);
    for (std::size_t s = 0; s < factor.nsuper; ++s)
      {
        const int n_rows = row_start[s + 1] - row_start[s];
        for (int column = std::max(first, super_start[s]);
             column < super_start[s + 1];
             ++column)
          for (int r = column - super_start[s]; r < n_rows; ++r)
            block[rows[row_start[s] + r] - first + (column - first) * n] =
              values[value_start[s] + r + (column - super_start[s]) * n_rows];
      }
    return block;
  }



  double
  SparseCholesky::n_factor_entries() const
  {
    return implementation_->common.lnz;
  }
} // namespace Signorini
