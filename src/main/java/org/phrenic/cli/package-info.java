/** Floor 6: the command line, one class a command. The only place that prints. */
package org.phrenic.cli;
