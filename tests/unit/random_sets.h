#ifndef tests_unit_random_sets_h
#define tests_unit_random_sets_h

/** How many random sets of parameters a generator gets: with the assertions
 * of deal.II each takes seconds. */
#ifdef DEBUG
constexpr unsigned int n_random_sets = 2;
#else
constexpr unsigned int n_random_sets = 20;
#endif

#endif
