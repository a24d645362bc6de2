/** What commands print and write: tables, progress, facts about files, pictures of reports. No options. */
package org.phrenic.cli.report;
