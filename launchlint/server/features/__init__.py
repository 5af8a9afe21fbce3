"""What is answered to each request of the protocol, one module for what belongs together."""
