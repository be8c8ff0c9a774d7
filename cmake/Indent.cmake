# `indent` formats every source, `check-indent` only says what it would change.
add_custom_target(indent COMMAND ${PROJECT_SOURCE_DIR}/scripts/format VERBATIM)
add_custom_target(check-indent COMMAND ${PROJECT_SOURCE_DIR}/scripts/format --check VERBATIM)
