/** Text tables, progress and messages of commands. */
package org.phrenic.cli.report;
