package org.phrenic.scene.gl;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import com.jogamp.common.util.VersionNumber;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.phrenic.scene.SceneFixture;

/** A context without a window. */
class OffscreenContextTest {
    @Test
    void opensAgainAndAgainAndSaysWhatDraws() {
        for (int i = 0; i < 3; i++) {
            try (OffscreenContext offscreen = SceneFixture.openOrSkip()) {
                assertThat(offscreen.info().version()).isNotBlank();
                assertThat(offscreen.info().maxSize()).isGreaterThanOrEqualTo(2048);
            }
        }
    }

    @Test
    void aPreparedContextServesOneOpening() {
        SceneFixture.openOrSkip().close();
        OffscreenContext.prepare();
        try (OffscreenContext prepared = SceneFixture.openOrSkip();
                OffscreenContext other = SceneFixture.openOrSkip()) {
            assertThat(prepared).isNotSameAs(other);
            assertThat(prepared.info().version()).isEqualTo(other.info().version());
        }
    }

    /** JOGL gives contexts of OpenGL 3.1 and 3.2 as well; their drivers compile none of the shaders. */
    @Test
    void anOldDriverIsToldInOneSentence() {
        assertThat(OffscreenContext.obstacle(new VersionNumber(3, 2, 0)))
                .contains("No pictures can be made here: the graphics driver has no OpenGL 3.3, it has 3.2");
        assertThat(OffscreenContext.obstacle(new VersionNumber(3, 3, 0))).isEmpty();
        assertThat(OffscreenContext.obstacle(new VersionNumber(4, 1, 0))).isEmpty();
    }

    /** Such as a server without X, where JOGL's library of X11 needs libXxf86vm nonetheless. */
    @Test
    void aMissingLibraryIsNamed() {
        UnsatisfiedLinkError error =
                new UnsatisfiedLinkError("/tmp/a: b/libnativewindow_x11.so: libXxf86vm.so.1: cannot"
                        + " open shared object file: No such file or directory");
        assertThat(NoGraphicsException.missingLibrary(error))
                .hasCause(error)
                .hasMessage(
                        "No pictures can be made here: the library libXxf86vm.so.1 is missing, which JOGL needs with"
                                + " an X server and without");
        assertThat(NoGraphicsException.missingLibrary(new UnsatisfiedLinkError("no awt in path")))
                .hasMessageContaining("no awt in path");
    }

    /** JOGL goes on without its libraries until the first method of theirs is called. */
    @Test
    void aTemporaryFolderThatTakesNoLibrariesIsNamed() {
        UnsatisfiedLinkError error =
                new UnsatisfiedLinkError("'boolean jogamp.common.jvm.JVMUtil.initialize(java.nio.ByteBuffer)'");
        assertThat(NoGraphicsException.missingLibrary(error))
                .hasCause(error)
                .hasMessageContaining(
                        "unpack its libraries into the temporary folder " + System.getProperty("java.io.tmpdir"))
                .hasMessageNotContaining("jogamp");
    }

    @Test
    void onlyADisplayThatAnswersCounts() {
        assertThat(DisplayServer.isReachable(null)).isFalse();
        assertThat(DisplayServer.isReachable("")).isFalse();
        assertThat(DisplayServer.isReachable("nonsense")).isFalse();
        assertThat(DisplayServer.isReachable(":nonsense")).isFalse();
        assertThat(DisplayServer.isReachable(":54321"))
                .as("no server has this number")
                .isFalse();
    }

    /** A server that says that it lacks GLX is not used; one that says nothing may have it. */
    @Test
    void onlyADisplayWithGlxDraws() throws Exception {
        assertThat(DisplayServer.hasGlx(null)).isFalse();
        assertThat(DisplayServer.hasGlx(":54321")).isFalse();
        assertThat(hasGlx(Optional.of(true))).isTrue();
        assertThat(hasGlx(Optional.of(false))).isFalse();
        assertThat(hasGlx(Optional.empty())).isTrue();
    }

    /** As behind a forwarded connection whose other end sleeps. */
    @Test
    void aServerThatIsSilentDoesNotDraw() throws Exception {
        try (ServerSocket server = displayPort()) {
            assertThat(DisplayServer.hasGlx("localhost:" + (server.getLocalPort() - 6000) + ".0", 100))
                    .isFalse();
        }
    }

    /** Only who draws through an X server can be told to draw without it. */
    @Test
    void withoutAServerNothingIsDrawnThroughOne() {
        assertThat(OffscreenContext.isOnXServer(null)).isFalse();
        assertThat(OffscreenContext.isOnXServer(":54321")).isFalse();
        assertThat(OffscreenContext.advised("Too old", null)).isEqualTo("Too old");
    }

    /** Such as a server at the other end of a connection, whose OpenGL is older than that of this machine. */
    @Test
    void whoDrawsThroughAServerIsToldTheOtherWay() throws Exception {
        assumeThat(DisplayServer.isNotNeeded()).isFalse();
        assumeThat(System.getProperty("phrenic.opengl", "")).isEmpty();
        String advised = atServer(Optional.of(true), display -> OffscreenContext.advised("Too old", display));
        assertThat(advised).isEqualTo("Too old; java -Dphrenic.opengl=egl may draw without the display");
    }

    /** @param answer what a server says when it is asked for GLX; empty for one that refuses the session */
    private static boolean hasGlx(Optional<Boolean> answer) throws IOException, InterruptedException {
        return atServer(answer, DisplayServer::hasGlx);
    }

    private static <T> T atServer(Optional<Boolean> answer, Function<String, T> question)
            throws IOException, InterruptedException {
        try (ServerSocket server = displayPort()) {
            Thread serving = new Thread(() -> serve(server, answer), "display");
            serving.start();
            T told = question.apply("localhost:" + (server.getLocalPort() - 6000) + ".0");
            serving.join();
            return told;
        }
    }

    private static ServerSocket displayPort() throws IOException {
        for (int number = 700; ; number++) {
            try {
                return new ServerSocket(6000 + number, 5, InetAddress.getByName("localhost"));
            } catch (BindException e) {
                // Another program listens there.
            }
        }
    }

    private static void serve(ServerSocket server, Optional<Boolean> answer) {
        try {
            server.accept().close();
            try (Socket client = server.accept()) {
                InputStream in = client.getInputStream();
                byte[] setup = in.readNBytes(12);
                boolean big = setup[0] == 'B';
                int key = big ? 1 : 0;
                in.readNBytes((setup[6 + key] + 3) / 4 * 4 + (setup[8 + key] + 3) / 4 * 4);
                byte[] session = new byte[8 + 4];
                session[0] = (byte) (answer.isPresent() ? 1 : 0);
                session[6 + key] = 1;
                client.getOutputStream().write(session);
                if (answer.isPresent()) {
                    byte[] query = in.readNBytes(12);
                    byte[] reply = new byte[32];
                    reply[0] = 1;
                    reply[8] = (byte) (answer.get() && new String(query, 8, 3, US_ASCII).equals("GLX") ? 1 : 0);
                    client.getOutputStream().write(reply);
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** One entry of a file of keys: family, address, number of the display, name and data. */
    private static byte[] entry(int family, String address, String number, byte key) {
        ByteBuffer out = ByteBuffer.allocate(100).putShort((short) family);
        for (String field : List.of(address, number, "MIT-MAGIC-COOKIE-1")) {
            out.putShort((short) field.length()).put(field.getBytes(StandardCharsets.US_ASCII));
        }
        out.putShort((short) 1).put(key).flip();
        return Arrays.copyOf(out.array(), out.limit());
    }

    /** The key of a display that ssh forwards to port 6010 of this machine stands under the name of the machine. */
    @Test
    void theKeyOfAForwardedDisplayIsThatOfThisMachine() {
        byte[] local = entry(256, "host", "10", (byte) 7);
        byte[] remote = entry(0, "abcd", "3", (byte) 8);
        byte[] all = ByteBuffer.allocate(local.length + remote.length)
                .put(local)
                .put(remote)
                .array();
        assertThat(DisplayServer.cookie("localhost:10.0", ByteBuffer.wrap(all))).containsExactly(7);
        assertThat(DisplayServer.cookie(":10", ByteBuffer.wrap(all))).containsExactly(7);
        assertThat(DisplayServer.cookie("elsewhere:10", ByteBuffer.wrap(all))).isEmpty();
        assertThat(DisplayServer.cookie("elsewhere:3", ByteBuffer.wrap(all))).containsExactly(8);
        assertThat(DisplayServer.cookie(":3", ByteBuffer.wrap(all))).isEmpty();
    }
}
