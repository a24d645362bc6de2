/** Options that commands share, and the conversion of their text to values. */
package org.phrenic.cli.option;
