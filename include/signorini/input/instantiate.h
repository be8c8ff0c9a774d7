#ifndef signorini_input_instantiate_h
#define signorini_input_instantiate_h

/**
 * Writes MACRO(dim) for two and for three dimensions. MACRO holds the explicit
 * instantiations of a file.
 */
#define SIGNORINI_FOR_EACH_DIMENSION(MACRO) MACRO(2) MACRO(3)

#endif
