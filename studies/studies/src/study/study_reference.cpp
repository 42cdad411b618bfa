// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/schema/publish.hpp>
#include <twum/studies/study/study_file.hpp>

#include <utility>

namespace twum::studies {
namespace {

constexpr const char* kIntroduction = R"text(# The study file

A study file names a motor and says what is asked of it. `twum init KIND` writes one to start from, `twum check FILE`
says everything that is wrong with one, `twum run FILE` runs it. This page is the output of
`twum schema study --format markdown`; `twum schema study` is the same for editors, as JSON Schema.

```yaml
twum: 1
motor: ring-60.yaml              # a path beside this file, or the motor itself
set: {preload: 140 N}
study:
  kind: sweep
  variables:
    amplitude: {min: 0.8 um, max: 2.2 um, points: 8}
    preload: [100 N, 160 N, 220 N]
  sampling: grid
  metrics:
    - stall_torque
    - wear_intensity_at(80 rpm)
```

Values carry units; a number without a unit is for a parameter without one. `NAME` stands for a [parameter](parameters.md), by name or
symbol (below `choose`, for a name of your own); its values are quantities of its dimension within its range. Where a [metric](metrics.md) may stand, a parameter
may too. `[]` stands for every item of a list. The third column is the default of an entry that is left out. Options of single
solvers, below `solver: options:`, are on the page of the [solvers](solvers.md).

)text";

constexpr const char* kSampling = R"text(
| sampling | designs |
| --- | --- |
| `grid` | all combinations; the last variable changes fastest; `points` values of a range, both ends included |
| `list` | the first values of all variables, then the second ones, ...; all lists have one length |
| `lhs` | `samples` designs of a Latin hypercube: each of `samples` equal parts of every range is met once |
| `sobol` | the first `samples` points of the Sobol sequence, shifted as the seed says |

On a logarithmic scale equal parts are those of the logarithm. `lhs` and `sobol` draw from a list of values, and whole
numbers such as `wavelengths`, each with the same share (on a logarithmic scale, the whole number k has that of k to k + 1).
)text";

// The entries below `study:` for one kind, without `kind`, which is the heading.
Schema entries_of(StudyKind kind) {
  Schema schema = study_schema(kind);
  std::erase_if(schema.entries, [](const SchemaEntry& entry) { return entry.name == "kind"; });
  return schema;
}

}  // namespace

std::string study_reference() {
  std::string text = kIntroduction;
  Schema file = study_file_schema();
  std::erase_if(file.entries, [](const SchemaEntry& entry) { return entry.name == "study"; });
  for (SchemaEntry& entry : file.entries) {
    if (entry.name != "motor") continue;
    entry.schema = Schema{};
    entry.schema.text = "a path from the folder of this file, or the entries of a motor";
    entry.schema.example = "ring-60.yaml";
  }
  text += markdown_table(file) + "\nBelow `study:` stand `kind` and the entries of that kind:\n";
  for (std::size_t i = 0; i < study_kinds().size(); ++i) {
    const auto kind = static_cast<StudyKind>(i);
    const Schema schema = entries_of(kind);
    text += "\n## " + std::string(to_string(kind)) + "\n\nAsks: " + schema.text + ".\n\n" +
            markdown_table(schema);
    if (kind == StudyKind::sweep) text += kSampling;
  }
  return text;
}

}  // namespace twum::studies
