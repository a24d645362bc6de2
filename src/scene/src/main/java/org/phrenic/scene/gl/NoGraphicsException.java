package org.phrenic.scene.gl;

/** Thrown if no OpenGL 3.3 context is available. The message is one sentence that names what is missing. */
public final class NoGraphicsException extends Exception {
    private static final long serialVersionUID = 1;

    public NoGraphicsException(String sentence) {
        super(sentence);
    }

    public NoGraphicsException(String sentence, Throwable cause) {
        super(sentence, cause);
    }
}
