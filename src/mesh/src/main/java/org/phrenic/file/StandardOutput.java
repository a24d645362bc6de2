package org.phrenic.file;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Locale;
import java.util.Optional;

/**
 * Standard output for results. It keeps the first reason why something could not be written, which a
 * {@code PrintWriter} drops. A reader that has read enough, such as {@code head}, is no failure.
 */
public final class StandardOutput extends FilterOutputStream {
    private Optional<String> failure = Optional.empty();

    public StandardOutput() {
        this(new FileOutputStream(FileDescriptor.out));
    }

    StandardOutput(OutputStream stream) {
        super(stream);
    }

    /** Why results are lost; empty if none are. */
    public synchronized Optional<String> failure() {
        return failure;
    }

    @Override
    public synchronized void write(int b) throws IOException {
        write(new byte[] {(byte) b}, 0, 1);
    }

    @Override
    public synchronized void write(byte[] bytes, int from, int count) throws IOException {
        try {
            out.write(bytes, from, count);
        } catch (IOException e) {
            String reason = String.valueOf(e.getMessage());
            boolean readerHasGone = reason.toLowerCase(Locale.ROOT).contains("pipe");
            if (failure.isEmpty() && !readerHasGone) {
                failure = Optional.of(reason);
            }
            throw e;
        }
    }
}
