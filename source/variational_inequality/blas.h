#ifndef signorini_variational_inequality_blas_h
#define signorini_variational_inequality_blas_h

#include <deal.II/lac/lapack_support.h>

// The BLAS and LAPACK routines of this room; deal.II 9.4 declares only some of
// them. Names end in an underscore as everywhere on Linux. All matrices are
// stored by columns.
namespace Signorini
{
  namespace Blas
  {
    using Integer = dealii::types::blas_int;

    extern "C"
    {
      double
      ddot_(const Integer *n,
            const double  *x,
            const Integer *incx,
            const double  *y,
            const Integer *incy);

      // y <- y + alpha x.
      void
      daxpy_(const Integer *n,
             const double  *alpha,
             const double  *x,
             const Integer *incx,
             double        *y,
             const Integer *incy);

      // y <- beta y + alpha op(A) x.
      void
      dgemv_(const char    *trans,
             const Integer *m,
             const Integer *n,
             const double  *alpha,
             const double  *a,
             const Integer *lda,
             const double  *x,
             const Integer *incx,
             const double  *beta,
             double        *y,
             const Integer *incy);

      // x <- op(A)^-1 x, A triangular.
      void
      dtrsv_(const char    *uplo,
             const char    *trans,
             const char    *diag,
             const Integer *n,
             const double  *a,
             const Integer *lda,
             double        *x,
             const Integer *incx);

      // x <- op(A) x, A triangular.
      void
      dtrmv_(const char    *uplo,
             const char    *trans,
             const char    *diag,
             const Integer *n,
             const double  *a,
             const Integer *lda,
             double        *x,
             const Integer *incx);

      // B <- alpha op(A)^-1 B or alpha B op(A)^-1, A triangular.
      void
      dtrsm_(const char    *side,
             const char    *uplo,
             const char    *trans,
             const char    *diag,
             const Integer *m,
             const Integer *n,
             const double  *alpha,
             const double  *a,
             const Integer *lda,
             double        *b,
             const Integer *ldb);

      // B <- alpha op(A) B or alpha B op(A), A triangular.
      void
      dtrmm_(const char    *side,
             const char    *uplo,
             const char    *trans,
             const char    *diag,
             const Integer *m,
             const Integer *n,
             const double  *alpha,
             const double  *a,
             const Integer *lda,
             double        *b,
             const Integer *ldb);

      // C <- alpha op(A) op(B) + beta C.
      void
      dgemm_(const char    *transa,
             const char    *transb,
             const Integer *m,
             const Integer *n,
             const Integer *k,
             const double  *alpha,
             const double  *a,
             const Integer *lda,
             const double  *b,
             const Integer *ldb,
             const double  *beta,
             double        *c,
             const Integer *ldc);

      // A = L L^T.
      void
      dpotrf_(const char    *uplo,
              const Integer *n,
              double        *a,
              const Integer *lda,
              Integer       *info);

      // A = P L U with row interchanges.
      void
      dgetrf_(const Integer *m,
              const Integer *n,
              double        *a,
              const Integer *lda,
              Integer       *ipiv,
              Integer       *info);

      // B <- op(A)^-1 B from the factors of dgetrf.
      void
      dgetrs_(const char    *trans,
              const Integer *n,
              const Integer *nrhs,
              const double  *a,
              const Integer *lda,
              const Integer *ipiv,
              double        *b,
              const Integer *ldb,
              Integer       *info);

      // P^T A P = L L^T with complete pivoting, A semidefinite.
      void
      dpstrf_(const char    *uplo,
              const Integer *n,
              double        *a,
              const Integer *lda,
              Integer       *piv,
              Integer       *rank,
              const double  *tol,
              double        *work,
              Integer       *info);
    }
  } // namespace Blas
} // namespace Signorini

#endif
