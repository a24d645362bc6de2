/** Output of commands: tables, progress, file summaries, report pictures. No options. */
package org.phrenic.cli.report;
