#!/usr/bin/env bash
# One text of a kernel with one set of options, for Clang to look at: tests/lint.sh calls this. Prints what Clang says of it; exit code 1 if it says anything.
text=$1
shift
left_out=(
  comma                        # statements of several assignments
  conditional-uninitialized    # loops whose first turn the compiler cannot foresee; -Wuninitialized stays
  declaration-after-statement  # forbidden before C99
  float-equal                  # comparisons with 0 and with the value itself are meant
  padded                       # records of the border have layouts that the host tests
  pedantic-core-features       # double precision is asked for where a device may lack it
  unreachable-code             # features are constants
  unreachable-code-return
  unused-function              # one text of mathematics serves every kernel
  unused-macros
  unused-parameter             # kinds of light and eye have the same parameters
  unused-command-line-argument # -cl-denorms-are-zero, without code to generate
)
exec clang -x cl -fsyntax-only -Weverything "${left_out[@]/#/-Wno-}" -Werror "$@" "$text"
