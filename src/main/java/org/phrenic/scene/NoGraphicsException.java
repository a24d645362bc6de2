package org.phrenic.scene;
public class NoGraphicsException extends Exception { public NoGraphicsException(String m) { super(m); } }
