package org.phrenic.document;

import java.io.File;
import java.util.regex.Pattern;

/** Texts as words of a command line: of a shell, and on Windows of its command prompt. */
public final class ShellWord {
    private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_./:=+,@%-]+");

    /** The PowerShell takes a comma as a list and an at sign as a variable. */
    private static final Pattern PLAIN_ON_WINDOWS = Pattern.compile("[A-Za-z0-9_./:=+\\\\-]+");

    private ShellWord() {}

    /** The text as one word: as it is, or in quotes where the command line would take it otherwise. */
    public static String quoted(String text) {
        return quoted(text, File.separatorChar == '\\');
    }

    /** As {@link #quoted(String)}: in double quotes on Windows, whose command prompt knows no single ones. */
    static String quoted(String text, boolean windows) {
        if (!windows) {
            return PLAIN.matcher(text).matches() ? text : "'" + text.replace("'", "'\\''") + "'";
        }
        // A program reads a backslash before a quote as an escape, and two as one backslash.
        String escaped = text.replaceAll("(\\\\*)\"", "$1$1\\\\\"").replaceAll("(\\\\+)$", "$1$1");
        return PLAIN_ON_WINDOWS.matcher(text).matches() ? text : '"' + escaped + '"';
    }
}
