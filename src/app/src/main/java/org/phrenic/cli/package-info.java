/**
 * The command line, one class per command. The only part of the module that prints, parses options and ends the
 * process.
 */
package org.phrenic.cli;
