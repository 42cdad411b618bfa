// SPDX-License-Identifier: Apache-2.0
// What the page's scripts find beside them; for scripts/lint.sh alone.
declare const uPlot: any;
declare const jsyaml: any;
declare const DecompressionStream: any;
