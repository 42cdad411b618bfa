#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Format and lint. Needs the packages of `scripts/install-deps.sh long`.
#
#   scripts/lint.sh           says which files clang-format would change, and checks the report's scripts
#   scripts/lint.sh --fix     changes them
#   scripts/lint.sh --tidy    format, then clang-tidy over core, motion, solid, optim, studies and apps
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

format=$(command -v clang-format-14 || command -v clang-format)
mapfile -t files < <(find core motion solid optim studies apps bench tests bindings examples -name '*.[ch]pp' 2>/dev/null | sort)
mapfile -t scripts < <(find studies/page -name '*.js' | sort)
if [[ ${1:-} == --fix ]]; then
  exec "$format" -i "${files[@]}" "${scripts[@]}"
fi
"$format" --dry-run --Werror "${files[@]}" "${scripts[@]}"
# The pages' modules: names, arguments and types, as far as they can be inferred.
tsc --noEmit --allowJs --checkJs --noUnusedLocals --noUnusedParameters --target es2022 --module es2022 \
  --lib es2022,dom,dom.iterable studies/page/*.d.ts "${scripts[@]}"

if [[ ${1:-} == --tidy ]]; then
  configure dev
  mapfile -t sources < <(find core motion solid optim studies apps -name '*.cpp' | sort)
  printf '%s\n' "${sources[@]}" |
    xargs -P "$(jobs)" -n 1 "$(command -v clang-tidy-14 || command -v clang-tidy)" --quiet -p build/dev
fi
