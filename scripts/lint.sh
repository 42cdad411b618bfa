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
# --dry-run of clang-format 14 takes `namespace a::inline b` for wrong, but would change nothing.
for file in "${files[@]}" "${scripts[@]}"; do
  "$format" "$file" | cmp --silent - "$file" || { echo "$file: not as clang-format has it" >&2; unformatted=yes; }
done
[[ -z ${unformatted:-} ]]
# The pages' modules: names, arguments and types, as far as they can be inferred.
tsc --noEmit --allowJs --checkJs --noUnusedLocals --noUnusedParameters --target es2022 --module es2022 \
  --lib es2022,dom,dom.iterable studies/page/*.d.ts "${scripts[@]}"

if [[ ${1:-} == --tidy ]]; then
  configure dev
  mapfile -t sources < <(find core motion solid optim studies apps -name '*.cpp' | sort)
  printf '%s\n' "${sources[@]}" |
    xargs -P "$(jobs)" -n 1 "$(command -v clang-tidy-14 || command -v clang-tidy)" --quiet -p build/dev
fi
