package org.phrenic.file;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/**
 * Standard output for results. It keeps the first reason why something could not be written, which a
 * {@code PrintWriter} drops. A reader that has read enough, such as {@code head}, is no failure.
 */
public final class StandardOutput extends FilterOutputStream {
    /** Standard output of this process, where the system has a path for it. */
    private static final Path DEVICE = Path.of("/dev/fd/1");
    /** Bits of a Unix file mode that state the type of the file. */
    private static final int TYPE_BITS = 0170000;

    private static final int PIPE = 0010000;
    private static final int SOCKET = 0140000;

    private final Path device;
    private Optional<String> failure = Optional.empty();

    public StandardOutput() {
        this(new FileOutputStream(FileDescriptor.out), DEVICE);
    }

    /** @param device what the stream writes to */
    StandardOutput(OutputStream stream, Path device) {
        super(stream);
        this.device = device;
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
            if (failure.isEmpty() && !readerHasGone(reason)) {
                failure = Optional.of(reason);
            }
            throw e;
        }
    }

    /**
     * Whether a write failed because no program reads on: a pipe and a socket fail for no other reason. On a system
     * that tells no types of files, the message tells it, which is in the language of the user.
     */
    private boolean readerHasGone(String reason) {
        try {
            int type = (int) Files.getAttribute(device, "unix:mode") & TYPE_BITS;
            return type == PIPE || type == SOCKET;
        } catch (IOException | UnsupportedOperationException | IllegalArgumentException unknown) {
            return reason.toLowerCase(Locale.ROOT).contains("pipe");
        }
    }
}
