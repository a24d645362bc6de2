package org.phrenic.scene.gl;

import java.io.EOFException;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.SocketTimeoutException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/**
 * Tests whether an X server is reachable and has GLX. Must run before JOGL is loaded, because JOGL chooses the window
 * system once per process.
 */
final class DisplayServer {
    private static final int FIRST_PORT = 6000;
    private static final int TIMEOUT_MS = 2000;

    private static final String COOKIE = "MIT-MAGIC-COOKIE-1";
    private static final String GLX = "GLX";
    private static final int QUERY_EXTENSION = 98;
    private static final int REPLY_BYTES = 32;
    private static final int LOCAL_FAMILY = 256;
    private static final int WILD_FAMILY = 65535;

    private DisplayServer() {}

    /** Whether this platform (macOS, Windows) needs no X server. */
    static boolean isNotNeeded() {
        String os = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        return os.contains("mac") || os.contains("win");
    }

    /**
     * Whether the server that the variable DISPLAY names accepts a connection.
     *
     * @param display value of DISPLAY, such as {@code :0} or {@code localhost:10.0}; null or empty for none
     */
    static boolean isReachable(String display) {
        try (SocketChannel channel = connect(display)) {
            return channel.isConnected();
        } catch (IOException | RuntimeException e) {
            return false;
        }
    }

    /**
     * Whether the server that the variable DISPLAY names draws with OpenGL: it accepts a connection, and does not say
     * that it lacks the extension GLX. A server that refuses the question may have it; one that is silent is of no use,
     * as that behind a connection whose other end sleeps.
     */
    static boolean hasGlx(String display) {
        return hasGlx(display, TIMEOUT_MS);
    }

    /** As {@link #hasGlx(String)}, of a server that is silent for so long, ms. */
    static boolean hasGlx(String display, int silenceMs) {
        if (!isReachable(display)) {
            return false;
        }
        try (SocketChannel channel = connect(display)) {
            channel.configureBlocking(false);
            return openSession(channel, cookie(display), silenceMs) ? queryGlx(channel, silenceMs) : true;
        } catch (SocketTimeoutException silent) {
            return false;
        } catch (IOException | RuntimeException e) {
            return true;
        }
    }

    private static boolean isHere(String display) {
        String host = display.substring(0, display.lastIndexOf(':'));
        return host.isEmpty() || host.equals("unix");
    }

    /** Whether a server's key is kept as that of a display of this machine, as that of a forwarded one is. */
    private static boolean hasLocalKey(String display) {
        String host = display.substring(0, display.lastIndexOf(':'));
        return isHere(display) || host.equals("localhost") || host.startsWith("127.");
    }

    private static int number(String display) {
        return Integer.parseInt(display.substring(display.lastIndexOf(':') + 1).replaceAll("\\..*", ""));
    }

    /** @throws RuntimeException if the text names no display */
    private static SocketChannel connect(String display) throws IOException {
        int number = number(display);
        if (isHere(display)) {
            return SocketChannel.open(UnixDomainSocketAddress.of("/tmp/.X11-unix/X" + number));
        }
        SocketChannel channel = SocketChannel.open(StandardProtocolFamily.INET);
        try {
            String host = display.substring(0, display.lastIndexOf(':'));
            channel.socket().connect(new InetSocketAddress(host, FIRST_PORT + number), TIMEOUT_MS);
            return channel;
        } catch (IOException | RuntimeException e) {
            channel.close();
            throw e;
        }
    }

    /** Opens a session of the X protocol; false if the server refuses it. */
    private static boolean openSession(SocketChannel channel, byte[] cookie, int silenceMs) throws IOException {
        byte[] name = cookie.length == 0 ? new byte[0] : COOKIE.getBytes(StandardCharsets.US_ASCII);
        ByteBuffer setup = buffer(12 + padded(name.length) + padded(cookie.length));
        setup.put((byte) (setup.order() == ByteOrder.BIG_ENDIAN ? 'B' : 'l')).put((byte) 0);
        setup.putShort((short) 11).putShort((short) 0);
        setup.putShort((short) name.length).putShort((short) cookie.length).putShort((short) 0);
        setup.put(name).position(12 + padded(name.length)).put(cookie).rewind();
        write(channel, setup);
        ByteBuffer answer = read(channel, 8, silenceMs);
        boolean accepted = answer.get(0) == 1;
        read(channel, 4 * Short.toUnsignedInt(answer.getShort(6)), silenceMs);
        return accepted;
    }

    private static boolean queryGlx(SocketChannel channel, int silenceMs) throws IOException {
        ByteBuffer query = buffer(8 + padded(GLX.length()));
        query.put((byte) QUERY_EXTENSION).put((byte) 0).putShort((short) (query.capacity() / 4));
        query.putShort((short) GLX.length()).putShort((short) 0);
        query.put(GLX.getBytes(StandardCharsets.US_ASCII)).rewind();
        write(channel, query);
        return read(channel, REPLY_BYTES, silenceMs).get(8) != 0;
    }

    private static ByteBuffer buffer(int bytes) {
        // Some servers refuse clients of the other order.
        return ByteBuffer.allocate(bytes).order(ByteOrder.nativeOrder());
    }

    private static int padded(int bytes) {
        return (bytes + 3) / 4 * 4;
    }

    private static void write(SocketChannel channel, ByteBuffer bytes) throws IOException {
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }

    private static ByteBuffer read(SocketChannel channel, int bytes, int silenceMs) throws IOException {
        ByteBuffer answer = buffer(bytes);
        try (Selector selector = channel.provider().openSelector()) {
            channel.register(selector, SelectionKey.OP_READ);
            for (int read = channel.read(answer); answer.hasRemaining(); read = channel.read(answer)) {
                if (read < 0) {
                    throw new EOFException("the X server closed the connection");
                }
                if (read == 0 && selector.select(silenceMs) == 0) {
                    throw new SocketTimeoutException("the X server is silent");
                }
                selector.selectedKeys().clear();
            }
        }
        return answer.flip();
    }

    /** The key to a display in the user's file of keys; empty if there is none. */
    private static byte[] cookie(String display) {
        Path file = Optional.ofNullable(System.getenv("XAUTHORITY"))
                .map(Path::of)
                .orElse(Path.of(System.getProperty("user.home"), ".Xauthority"));
        try {
            return cookie(display, ByteBuffer.wrap(Files.readAllBytes(file)));
        } catch (IOException | RuntimeException e) {
            // Without a key the server may still accept the connection.
            return new byte[0];
        }
    }

    /**
     * The key to a display; empty if there is none.
     *
     * @param entries content of a file of keys
     */
    static byte[] cookie(String display, ByteBuffer entries) {
        while (entries.hasRemaining()) {
            int family = Short.toUnsignedInt(entries.getShort());
            next(entries);
            String number = new String(next(entries), StandardCharsets.US_ASCII);
            String name = new String(next(entries), StandardCharsets.US_ASCII);
            byte[] data = next(entries);
            boolean same = number.isEmpty() || number.equals(String.valueOf(number(display)));
            boolean place = family == WILD_FAMILY || (family == LOCAL_FAMILY ? hasLocalKey(display) : !isHere(display));
            if (same && place && name.equals(COOKIE)) {
                return data;
            }
        }
        return new byte[0];
    }

    /** Next field of an entry, which begins with its length. */
    private static byte[] next(ByteBuffer entries) {
        byte[] field = new byte[Short.toUnsignedInt(entries.getShort())];
        entries.get(field);
        return field;
    }
}
