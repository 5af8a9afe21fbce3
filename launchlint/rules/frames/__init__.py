"""Rules about coordinate frames: who publishes their transforms, and who asks for them."""
