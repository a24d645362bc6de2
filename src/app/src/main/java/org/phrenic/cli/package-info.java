/** The command line, one class a command; the only module part that prints, parses options and ends the process. */
package org.phrenic.cli;
