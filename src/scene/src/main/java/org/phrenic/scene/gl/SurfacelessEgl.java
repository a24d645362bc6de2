package org.phrenic.scene.gl;

import com.jogamp.common.jvm.JNILibLoaderBase;
import com.jogamp.common.os.NativeLibrary;
import com.jogamp.common.os.Platform;
import com.jogamp.common.util.LongObjectHashMap;
import com.jogamp.common.util.cache.TempJarCache;
import com.jogamp.nativewindow.NativeWindowFactory;
import com.jogamp.opengl.GLDrawableFactory;
import com.jogamp.opengl.GLProfile;
import com.jogamp.opengl.GLRendererQuirks;
import com.jogamp.opengl.egl.EGL;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.util.List;
import java.util.Optional;

/**
 * Configures JOGL to render through surfaceless EGL, without an X server (Linux). JOGL must be told before its first
 * use that there is no window system, that Mesa has no surface for a shared context, and which library contains desktop
 * OpenGL. JOGL's default EGL display is that of X; reflection is the only way to replace it.
 */
final class SurfacelessEgl extends JNILibLoaderBase {
    /** EGL_PLATFORM_SURFACELESS_MESA. */
    private static final int PLATFORM_SURFACELESS_MESA = 0x31DD;

    /** NativeWindowFactory.TYPE_EGL, spelled out because that class reads the property below when it is loaded. */
    private static final String WINDOW_SYSTEM = ".egl";

    private static final String NO_DISPLAY = "No pictures can be made here: there is no display, and ";
    private static final String UNKNOWN_VERSION =
            "No pictures can be made here: this version of JOGL cannot be told to draw without a display";

    /** Libraries that hold the functions of OpenGL for JOGL; without one of them it finds no profile. */
    private static final List<String> LIBRARIES = List.of("libGL.so.1", "libGLESv2.so.2");

    private SurfacelessEgl() {}

    /** The first library of the system that JOGL looks in for functions and that is missing. */
    static Optional<String> missingLibrary() {
        return LIBRARIES.stream()
                .filter(name ->
                        NativeLibrary.open(name, true, true, SurfacelessEgl.class.getClassLoader(), false) == null)
                .findFirst();
    }

    /** Must be called before any other use of JOGL in this process. */
    static GLDrawableFactory factory() throws NoGraphicsException {
        System.setProperty("nativewindow.ws.name", WINDOW_SYSTEM);
        overrideQuirks();
        Platform.initSingleton();
        NativeWindowFactory.initSingleton();
        if (TempJarCache.isInitialized(true)) {
            addNativeJarLibs(new Class<?>[] {GLProfile.class}, null);
        }
        if (!loadLibrary("jogl_desktop", true, SurfacelessEgl.class.getClassLoader())) {
            throw new NoGraphicsException("No pictures can be made here: the library jogl_desktop could not be loaded,"
                    + " it needs the X11 client libraries (libX11), though no X server");
        }
        GLDrawableFactory.initSingleton();
        installSurfacelessDisplay();
        GLDrawableFactory factory = GLDrawableFactory.getEGLFactory();
        if (factory == null) {
            throw new NoGraphicsException(NO_DISPLAY + "no EGL library (libEGL) to draw without one");
        }
        return factory;
    }

    /**
     * Sets JOGL's quirk masks directly, because the properties jogl.quirks.force and jogl.quirks.ignore print to
     * stderr.
     */
    private static void overrideQuirks() throws NoGraphicsException {
        try {
            override("_bitmaskOverrideForce", GLRendererQuirks.NoSurfacelessCtx);
            override("_bitmaskOverrideIgnore", GLRendererQuirks.GLES3ViaEGLES2Config);
        } catch (ReflectiveOperationException e) {
            throw new NoGraphicsException(UNKNOWN_VERSION, e);
        }
    }

    private static void override(String mask, int quirk) throws ReflectiveOperationException {
        Field field = GLRendererQuirks.class.getDeclaredField(mask);
        field.setAccessible(true);
        field.setInt(null, field.getInt(null) | 1 << quirk);
    }

    private static void installSurfacelessDisplay() throws NoGraphicsException {
        long display;
        try {
            display = EGL.eglGetPlatformDisplay(PLATFORM_SURFACELESS_MESA, 0L, null);
        } catch (RuntimeException | LinkageError e) {
            throw new NoGraphicsException(NO_DISPLAY + "no EGL library (libEGL 1.5) to draw without one", e);
        }
        if (display == 0) {
            throw new NoGraphicsException(
                    NO_DISPLAY + "EGL has no driver that draws without one (Mesa's libEGL is missing)");
        }
        try {
            Class<?> displays = Class.forName("jogamp.opengl.egl.EGLDisplayUtil");
            Method initialize = displays.getDeclaredMethod("eglInitialize", long.class, int[].class, int[].class);
            Method only = displays.getDeclaredMethod("setSingletonEGLDisplayOnly", boolean.class);
            initialize.setAccessible(true);
            only.setAccessible(true);
            if (!(boolean) initialize.invoke(null, display, new int[1], new int[1])) {
                throw new NoGraphicsException(NO_DISPLAY + "the driver of EGL does not start without one");
            }
            only.invoke(null, true);
            suppressShutdownWarning(displays);
        } catch (ReflectiveOperationException e) {
            throw new NoGraphicsException(UNKNOWN_VERSION, e);
        }
    }

    /**
     * Clears JOGL's list of open EGL displays at shutdown. The driver closes the display itself, but JOGL would report
     * it on stderr as left open.
     */
    private static void suppressShutdownWarning(Class<?> displays) throws ReflectiveOperationException {
        Field open = displays.getDeclaredField("openEGLDisplays");
        open.setAccessible(true);
        LongObjectHashMap left = (LongObjectHashMap) open.get(null);
        NativeWindowFactory.addCustomShutdownHook(true, left::clear);
    }
}
