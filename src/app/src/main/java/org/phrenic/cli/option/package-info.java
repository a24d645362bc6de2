/** Options shared by commands, and the conversion of option text to values. */
package org.phrenic.cli.option;
