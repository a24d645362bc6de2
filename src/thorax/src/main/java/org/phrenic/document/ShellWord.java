package org.phrenic.document;

import java.util.regex.Pattern;

/** Texts as words of a shell's command line. */
public final class ShellWord {
    private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_./:=+,@%-]+");

    private ShellWord() {}

    /** The text as one word: as it is, or in single quotes where the shell would take it otherwise. */
    public static String quoted(String text) {
        return PLAIN.matcher(text).matches() ? text : "'" + text.replace("'", "'\\''") + "'";
    }
}
