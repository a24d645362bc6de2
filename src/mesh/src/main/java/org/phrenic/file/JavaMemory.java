package org.phrenic.file;

/** Memory that Java may use, in messages. */
public final class JavaMemory {
    private JavaMemory() {}

    /**
     * A size with the option that raises it, such as "2048 MB (java -Xmx8g gives it 8 GB)".
     *
     * @param bytes what Java may use
     */
    public static String inWords(long bytes) {
        return (bytes >> 20) + " MB (java -Xmx8g gives it 8 GB)";
    }
}
